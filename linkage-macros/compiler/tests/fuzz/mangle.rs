//! Random slips of whoever writes a declaration: tokens left out, doubled, swapped, replaced,
//! numbers and names changed.

use super::seeds;
use proc_macro2::{Delimiter, Group, Ident, Punct, Spacing, Span, TokenStream, TokenTree};

/// Words and numbers that other declarations may have, and some that none has.
const WORDS: &str = "
    input param let ground guide point output numerics crate export crank slider rrr rrp rpr prp
    rpp prr mass on at through along towards polar distances angle length lengths mode slide offset
    offsets slot relative_to left right ahead behind compensated fast margin transmission number struct
    pi sqrt hypot sin cos tan asin acos atan atan2 abs sign min max exp ln tanh pow A B C D X q s type Self r#a _ theta x T Ok
    0 1 2 0.5 1e-3m 30deg 90deg 180deg 1turn 1e300 1e-300m 1e400 0x10 5mm 1in 7.25 3kg 1_000um
    2.5f64 'a' \"s\"";

pub(super) struct Mangler {
    seeds: Vec<Vec<TokenTree>>,
    words: Vec<TokenTree>,
    state: u64,
}

impl Mangler {
    pub(super) fn new(seed: u64) -> Self {
        let tokens = |text: &str| -> Vec<TokenTree> {
            let tokens: TokenStream = text.parse().expect("these are tokens");
            tokens.into_iter().map(without_span).collect()
        };
        let (seeds, words) = (seeds::all().map(tokens).collect(), tokens(WORDS));
        // Two steps away from small seeds, whose first numbers are alike.
        let mut mangler = Self { seeds, words, state: seed };
        mangler.draw(2);
        mangler.draw(2);
        mangler
    }

    /// Knuth's linear congruential generator; the high bits are good.
    fn draw(&mut self, below: usize) -> usize {
        self.state = self
            .state
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.state >> 33) as usize % below
    }

    /// The next mangled declaration.
    pub(super) fn next(&mut self) -> TokenStream {
        // The small ones most of the time: they take a tenth of the large ones' time.
        let known = if self.draw(8) > 0 { seeds::SMALL.len() } else { self.seeds.len() };
        let seed = self.draw(known);
        let mut trees = self.seeds[seed].clone();
        // One slip is a user's; several meet in one place.
        for _ in 0..=self.draw(3) * self.draw(2) {
            self.slip(&mut trees);
        }
        trees.into_iter().collect()
    }

    /// One slip somewhere in the sequence or inside one of its delimiters.
    fn slip(&mut self, trees: &mut Vec<TokenTree>) {
        let weight = |tree: &TokenTree| match tree {
            TokenTree::Group(group) => 1 + group.stream().into_iter().count() * 4,
            _ => 1,
        };
        let mut at = self.draw(1 + trees.iter().map(weight).sum::<usize>());
        for i in 0..trees.len() {
            let weight = weight(&trees[i]);
            if at >= weight {
                at -= weight;
                continue;
            }
            match &trees[i] {
                TokenTree::Group(group) if at > 0 => {
                    let mut inner: Vec<_> = group.stream().into_iter().collect();
                    self.slip(&mut inner);
                    let inner = inner.into_iter().collect();
                    trees[i] = TokenTree::Group(Group::new(group.delimiter(), inner));
                }
                _ => self.slip_at(trees, i),
            }
            return;
        }
        let new = self.any();
        trees.push(new);
    }

    fn slip_at(&mut self, trees: &mut Vec<TokenTree>, i: usize) {
        match self.draw(8) {
            0 => drop(trees.remove(i)),
            1 => trees.insert(i, trees[i].clone()),
            2 => {
                let next = (i + 1) % trees.len();
                trees.swap(i, next);
            }
            3 => {
                let new = self.any();
                trees.insert(i, new);
            }
            4 => trees[i] = self.any(),
            // A user's more likely slip: another word or number of the same kind.
            _ => trees[i] = self.alike(&trees[i].clone(), trees),
        }
    }

    /// Another token of the same kind, from here or from the list.
    fn alike(&mut self, tree: &TokenTree, trees: &[TokenTree]) -> TokenTree {
        if let TokenTree::Group(group) = tree {
            let delimiters = [Delimiter::Parenthesis, Delimiter::Brace, Delimiter::Bracket];
            let delimiter = delimiters[self.draw(3)];
            return TokenTree::Group(Group::new(delimiter, group.stream()));
        }
        if let TokenTree::Punct(_) = tree {
            return self.sign();
        }
        let kind = std::mem::discriminant(tree);
        let near = trees.iter().chain(&self.words);
        let known: Vec<_> = near.filter(|t| std::mem::discriminant(*t) == kind).cloned().collect();
        known[self.draw(known.len())].clone()
    }

    fn any(&mut self) -> TokenTree {
        match self.draw(4) {
            0 => self.sign(),
            1 => {
                let delimiters =
                    [Delimiter::Parenthesis, Delimiter::Brace, Delimiter::Bracket, Delimiter::None];
                let word = self.word();
                TokenTree::Group(Group::new(delimiters[self.draw(4)], word.into()))
            }
            2 => {
                TokenTree::Ident(Ident::new(["A", "B", "q", "s"][self.draw(4)], Span::call_site()))
            }
            _ => self.word(),
        }
    }

    fn word(&mut self) -> TokenTree {
        let at = self.draw(self.words.len());
        self.words[at].clone()
    }

    fn sign(&mut self) -> TokenTree {
        let sign = b",;:=+-*/.#!>^"[self.draw(13)] as char;
        let spacing = [Spacing::Alone, Spacing::Joint][self.draw(2)];
        TokenTree::Punct(Punct::new(sign, spacing))
    }
}

/// Spans of one text are forgotten between rounds, so the tokens that stay have none.
fn without_span(mut tree: TokenTree) -> TokenTree {
    if let TokenTree::Group(group) = &tree {
        let inner = group.stream().into_iter().map(without_span).collect();
        tree = TokenTree::Group(Group::new(group.delimiter(), inner));
    }
    tree.set_span(Span::call_site());
    tree
}
