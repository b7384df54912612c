//! Tests of `ir/hash`.

pub(crate) use linkage_compiler::ir::hash::*;

#[test]
fn a_map_finds_what_was_inserted_and_nothing_else() {
    let mut map = Map::default();
    assert!(map.is_empty() && map.get(&0).is_none());
    for key in 0..1000_u32 {
        assert!(map.insert(key * key, key));
    }
    assert!(!map.insert(49, 70));
    assert_eq!(*map.or_insert(49, 0), 70);
    assert_eq!(*map.or_insert(50, 51), 51);
    for key in 0..1000_u32 {
        let value = if key == 7 { 70 } else { key };
        assert_eq!(map[&(key * key)], value);
        assert!(key < 2 || map.contains(&(key * key + 2)) == (key == 0));
    }
    let squares = (0..1000).map(|key| key * key);
    assert!(map.keys().copied().eq(squares.chain([50])));
}

#[test]
fn a_map_with_room_is_as_one_that_grew() {
    let keys = || (0..100_u32).map(|key| (key % 40, key));
    let (mut roomy, grown) = (Map::with_room(40), keys().collect::<Map<_, _>>());
    roomy.extend(keys());
    assert!(roomy.values().eq(grown.values()) && roomy.keys().eq(grown.keys()));
    assert_eq!(roomy.slots.len(), 128);
}
