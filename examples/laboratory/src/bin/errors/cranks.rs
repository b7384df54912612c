// Written by `draw_mechanisms cranks` of this package, which says how.

twin! { twin_01, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.466113269329071044921875) (gy = 0.060431025922298431396484375)
     (a = 0.03716050088405609130859375) (l2 = 0.438969194889068603515625)
     (l3 = 0.13300399482250213623046875) (px = 0.02733560837805271148681640625)
     (py = 0.09429609775543212890625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_02, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.297297298908233642578125) (gy = 0.0)
     (a = 0.112955026328563690185546875) (b = 0.0541019923985004425048828125)
     (l2 = 0.3345466554164886474609375) (l3 = 0.2170829474925994873046875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: left } output C, BC, EC; } }

twin! { twin_04, "rrr behind a crank", [theta: angle],
    [(ax = 0.4375) (ay = -0.0625) (gx = 0.6056401729583740234375) (gy = -0.0625)
     (a = 0.200824320316314697265625) (l2 = 0.3432666957378387451171875)
     (l3 = 0.377751290798187255859375) (px = -0.11656747758388519287109375)
     (py = -0.031757675111293792724609375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_05, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.42848861217498779296875) (gy = 0.00281341071240603923797607421875)
     (a = 0.13924323022365570068359375) (b = 0.061328001320362091064453125)
     (l2 = 0.3238212168216705322265625) (l3 = 0.238740444183349609375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twin! { twin_07, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.3198812305927276611328125) (gy = 0.001202726387418806552886962890625)
     (a = 0.14567710459232330322265625) (l2 = 0.350779950618743896484375)
     (l3 = 0.3507799506187441185289799250313080847263336181640625) (px = -0.299764215946197509765625)
     (py = -0.14380834996700286865234375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_08, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.4403491914272308349609375) (gy = 0.0)
     (a = 0.2893103063106536865234375) (b = 0.0434657000005245208740234375)
     (l2 = 0.3314252793788909912109375) (l3 = 0.33142527937889110223323996251565404236316680908203125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twin! { twin_10, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.16298067569732666015625) (gy = 0.1577170789241790771484375)
     (a = 0.064087472856044769287109375) (l2 = 0.38918364048004150390625)
     (l3 = 0.3891835510730743408203125) (px = -0.16311378777027130126953125)
     (py = 0.2971188724040985107421875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_11, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.388172686100006103515625) (gy = -0.07378494739532470703125)
     (a = 0.041586935520172119140625) (b = 0.00455297529697418212890625)
     (l2 = 0.2620721161365509033203125) (l3 = 0.262072026729583740234375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: left } output C, BC, EC; } }

twin! { twin_13, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.3591875731945037841796875) (gy = 0.02156409062445163726806640625)
     (a = 0.02156409062445163726806640625) (l2 = 0.01742824353277683258056640625)
     (l3 = 0.3717667162418365478515625) (px = 0.1879338324069976806640625)
     (py = 0.09859450161457061767578125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_14, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.399476468563079833984375)
     (gy = 0.0000808340191724710166454315185546875) (a = 0.0000808340191724710166454315185546875)
     (b = 0.0000193029336514882743358612060546875) (l2 = 0.39953172206878662109375)
     (l3 = 0.00005173255703994072973728179931640625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: left } output C, BC, EC; } }

twin! { twin_16, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.1776412427425384521484375) (gy = 0.0)
     (a = 0.17761041224002838134765625) (l2 = 0.4740479886531829833984375)
     (l3 = 0.4740479886531829833984375) (px = -0.2390754520893096923828125)
     (py = -0.2797219753265380859375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_17, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.258688986301422119140625) (gy = 0.0)
     (a = 0.2582913339138031005859375) (b = 0.094926603138446807861328125) (l2 = 0.3992252349853515625)
     (l3 = 0.3992252349853515625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twin! { twin_19, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.3857246339321136474609375) (gy = 0.0)
     (a = 0.093449652194976806640625) (l2 = 0.3857246339321136474609375)
     (l3 = 0.093449652194976806640625) (px = -0.26652371883392333984375)
     (py = 0.1755345165729522705078125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_20, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.2685171067714691162109375) (gy = 0.0)
     (a = 0.050421535968780517578125) (b = 0.01922386325895786285400390625)
     (l2 = 0.2685171067714691162109375) (l3 = 0.050421535968780517578125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: left } output C, BC, EC; } }

twin! { twin_22, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.123950459063053131103515625) (gy = 0.0)
     (a = 0.1877879798412322998046875) (l2 = 0.326640546321868896484375)
     (l3 = 0.1725693047046661376953125) (px = 0.2330459058284759521484375)
     (py = -0.09306167066097259521484375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_23, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.12462298572063446044921875) (gy = -0.037577010691165924072265625)
     (a = 0.1757876574993133544921875) (b = 0.053633548319339752197265625)
     (l2 = 0.368556678295135498046875) (l3 = 0.333632171154022216796875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twin! { twin_25, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.250853002071380615234375) (gy = 0.0)
     (a = 0.21310763061046600341796875) (l2 = 0.300630152225494384765625)
     (l3 = 0.496737897396087646484375) (px = -0.28390491008758544921875)
     (py = 0.014379573054611682891845703125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_26, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.26473343372344970703125) (gy = 0.09995567798614501953125)
     (a = 0.1922439038753509521484375) (b = 0.1479832828044891357421875)
     (l2 = 0.2096734344959259033203125) (l3 = 0.114009715616703033447265625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twin! { twin_28, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.4428916871547698974609375) (gy = -0.068192742764949798583984375)
     (a = 0.09879742562770843505859375) (l2 = 0.48525989055633544921875)
     (l3 = 0.48525989055633556024105246251565404236316680908203125) (px = 0.09313391149044036865234375)
     (py = 0.273217380046844482421875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_29, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.23800344765186309814453125) (gy = 0.0)
     (a = 0.20381323993206024169921875) (b = 0.0694964826107025146484375)
     (l2 = 0.4799147546291351318359375) (l3 = 0.4799147546291353538805424250313080847263336181640625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: left } output C, BC, EC; } }

twin! { twin_31, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.268579185009002685546875) (gy = 0.18744488060474395751953125)
     (a = 0.0377396158874034881591796875) (l2 = 0.313517868518829345703125)
     (l3 = 0.3135178089141845703125) (px = 0.13020776212215423583984375)
     (py = 0.1774522364139556884765625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_32, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.125) (ay = 0.3125) (gx = 0.60865533351898193359375) (gy = 0.3125)
     (a = 0.09031428396701812744140625) (b = 0.034194983541965484619140625)
     (l2 = 0.309993565082550048828125) (l3 = 0.309993445873260498046875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twin! { twin_34, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.4221806824207305908203125) (gy = 0.0515136532485485076904296875)
     (a = 0.0515136532485485076904296875) (l2 = 0.0546472109854221343994140625)
     (l3 = 0.380523622035980224609375) (px = -0.001927399658598005771636962890625)
     (py = 0.0171837322413921356201171875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_35, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.25978457927703857421875) (gy = 0.0007299589342437684535980224609375)
     (a = 0.0007299589342437684535980224609375) (b = 0.0001092059465008787810802459716796875)
     (l2 = 0.00038555954233743250370025634765625) (l3 = 0.2601437270641326904296875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: left } output C, BC, EC; } }

twin! { twin_37, "rrr behind a crank", [theta: angle],
    [(ax = -0.125) (ay = -0.25) (gx = 0.12515985965728759765625) (gy = -0.25)
     (a = 0.2501594722270965576171875) (l2 = 0.4564058780670166015625) (l3 = 0.4564058780670166015625)
     (px = 0.25025022029876708984375) (py = 0.1996985375881195068359375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_38, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.0534676201641559600830078125) (gy = 0.0)
     (a = 0.0525883622467517852783203125) (b = 0.035011164844036102294921875)
     (l2 = 0.34042584896087646484375) (l3 = 0.34042584896087646484375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twin! { twin_40, "rrr behind a crank", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.351134836673736572265625) (gy = 0.0)
     (a = 0.0560662932693958282470703125) (l2 = 0.351134836673736572265625)
     (l3 = 0.0560662932693958282470703125) (px = -0.2424083650112152099609375)
     (py = 0.13667435944080352783203125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py); output C, P, BC, DC; } }

twin! { twin_41, "rrr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.2723000347614288330078125) (gy = 0.0)
     (a = 0.257274329662322998046875) (b = 0.17356596887111663818359375)
     (l2 = 0.2723000347614288330078125) (l3 = 0.257274329662322998046875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rrr BC(B), EC(E) -> C { lengths: (l2, l3), mode: right } output C, BC, EC; } }

twins! { cranks:
    twin_01
    twin_02
    twin_04
    twin_05
    twin_07
    twin_08
    twin_10
    twin_11
    twin_13
    twin_14
    twin_16
    twin_17
    twin_19
    twin_20
    twin_22
    twin_23
    twin_25
    twin_26
    twin_28
    twin_29
    twin_31
    twin_32
    twin_34
    twin_35
    twin_37
    twin_38
    twin_40
    twin_41
}
