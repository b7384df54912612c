// Written by `draw_mechanisms loops` of this package, which says how.

twin! { twin_03, "rrr on a turning arm", [r: length between 0.14198056399822234 0.47227045357227326, theta: angle],
    [(ax = 0.0) (ay = 0.0) (l2 = 0.307125508785247802734375) (l3 = 0.1619068086147308349609375)],
    { ground A(ax, ay); crank AB(A) -> B { length: r, angle: theta }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_06, "rrr on a turning arm", [r: length between 0.18868691563606263 0.7201407468318939, theta: angle],
    [(ax = 0.0) (ay = 0.0) (l2 = 0.260516583919525146484375) (l3 = 0.454413831233978271484375)],
    { ground A(ax, ay); crank AB(A) -> B { length: r, angle: theta }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_09, "rrr on a turning arm", [r: length between 4.818871319293976e-7 0.9734120064973832, theta: angle],
    [(ax = 0.25767457485198974609375) (ay = 0.467326343059539794921875)
     (l2 = 0.4818871319293975830078125) (l3 = 0.48188713192939769403011496251565404236316680908203125)],
    { ground A(ax, ay); crank AB(A) -> B { length: r, angle: theta }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: right } output C, BC, AC; } }

twin! { twin_12, "rrr on a turning arm", [r: length between 4.77690041065216e-7 0.9649338221549988, theta: angle],
    [(ax = -0.051761925220489501953125) (ay = 0.127530634403228759765625)
     (l2 = 0.477690041065216064453125) (l3 = 0.4776899814605712890625)],
    { ground A(ax, ay); crank AB(A) -> B { length: r, angle: theta }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_15, "rrr on a turning arm", [r: length between 0.29313831569214016 0.2931567525718674, theta: angle],
    [(ax = -0.23198032379150390625) (ay = 0.33827304840087890625) (l2 = 0.2931475341320037841796875)
     (l3 = 0.0000090376861408003605902194976806640625)],
    { ground A(ax, ay); crank AB(A) -> B { length: r, angle: theta }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_18, "rrr on a turning arm", [r: length between 2.65326589345932e-7 0.5359597104787827, theta: angle],
    [(ax = 0.0) (ay = 0.0) (l2 = 0.2653265893459320068359375) (l3 = 0.2653265893459320068359375)],
    { ground A(ax, ay); crank AB(A) -> B { length: r, angle: theta }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: right } output C, BC, AC; } }

twin! { twin_21, "rrr on a turning arm", [r: length between 0.11392675578594208 0.6603387123346329, theta: angle],
    [(ax = 0.494489848613739013671875) (ay = -0.103625714778900146484375)
     (l2 = 0.3871327340602874755859375) (l3 = 0.2678489983081817626953125)],
    { ground A(ax, ay); crank AB(A) -> B { length: r, angle: theta }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: right } output C, BC, AC; } }

twin! { twin_24, "rrr behind a slider", [r: length between 0.2904169809818268 0.5887956964969635],
    [(ax = -0.34599006175994873046875) (ay = 0.1127364635467529296875)
     (l2 = 0.4396063387393951416015625) (l3 = 0.14626407623291015625) (tilt = -1.00915682315826416015625)],
    { ground A(ax, ay); guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: right } output C, BC, AC; } }

twin! { twin_27, "rrr behind a slider", [r: length between 0.07392034441232681 0.34873172134160996],
    [(ax = 0.0) (ay = 0.0) (l2 = 0.13471145927906036376953125) (l3 = 0.2113260328769683837890625)
     (tilt = -2.7335567474365234375)],
    { ground A(ax, ay); guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_30, "rrr behind a slider", [r: length between 4.5387545228004456e-7 0.9168284136056902],
    [(ax = -0.2860896587371826171875) (ay = 0.383126318454742431640625)
     (l2 = 0.4538754522800445556640625) (l3 = 0.453875452280044722197516193773481063544750213623046875)
     (tilt = 1.45956623554229736328125)],
    { ground A(ax, ay); guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_33, "rrr behind a slider", [r: length between 3.882451057434082e-7 0.7842550224065781],
    [(ax = -0.4660494327545166015625) (ay = -0.27429687976837158203125) (l2 = 0.388245105743408203125)
     (l3 = 0.3882450163364410400390625) (tilt = -1.860272884368896484375)],
    { ground A(ax, ay); guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_36, "rrr behind a slider", [r: length between 0.286812729722933 0.28682630550198157],
    [(ax = 0.0) (ay = 0.0) (l2 = 0.0000066547936512506566941738128662109375)
     (l3 = 0.286819517612457275390625) (tilt = 0.6903927326202392578125)],
    { ground A(ax, ay); guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_39, "rrr behind a slider", [r: length between 4.0451911091804504e-7 0.817128604054451],
    [(ax = -0.273360431194305419921875) (ay = -0.00016152858734130859375)
     (l2 = 0.4045191109180450439453125) (l3 = 0.4045191109180450439453125)
     (tilt = -0.6978743076324462890625)],
    { ground A(ax, ay); guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: left } output C, BC, AC; } }

twin! { twin_42, "rrr behind a slider", [r: length between 0.12632809489965438 0.395423666536808],
    [(ax = 0.009565412998199462890625) (ay = 0.11438119411468505859375)
     (l2 = 0.260875880718231201171875) (l3 = 0.13190959393978118896484375)
     (tilt = 1.80771338939666748046875)],
    { ground A(ax, ay); guide rail through (ax, ay) along tilt; slider ram(rail) -> B { slide: r }
      rrr BC(B), AC(A) -> C { lengths: (l2, l3), mode: right } output C, BC, AC; } }

twin! { twin_43, "rrr behind rrr", [theta: angle],
    [(gx = 0.472130835056304931640625) (gy = 0.0) (px = -0.28203570842742919921875)
     (py = -0.27151238918304443359375) (fx = 0.01682817935943603515625) (fy = 0.50002634525299072265625)
     (a = 0.290877997875213623046875) (l2 = 0.123552344739437103271484375)
     (l3 = 0.1770550310611724853515625) (l4 = 0.4766236841678619384765625)
     (l5 = 0.3635580539703369140625)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: right } output C, P, E, DC, PE, FE; } }

twin! { twin_44, "rrr behind rrr", [theta: angle],
    [(gx = 0.13970029354095458984375) (gy = -0.0207636840641498565673828125)
     (px = -0.267748534679412841796875) (py = -0.19383995234966278076171875)
     (fx = -0.072788141667842864990234375) (fy = 0.533337295055389404296875)
     (a = 0.22721989452838897705078125) (l2 = 0.1997718513011932373046875)
     (l3 = 0.3267407715320587158203125) (l4 = 0.4291810095310211181640625)
     (l5 = 0.3637302219867706298828125)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: right } output C, P, E, DC, PE, FE; } }

twin! { twin_45, "rrr behind rrr", [theta: angle],
    [(gx = 0.10008843243122100830078125) (gy = -0.15188567340373992919921875)
     (px = -0.01615026034414768218994140625) (py = -0.194015085697174072265625)
     (fx = 0.480984389781951904296875) (fy = 0.487321674823760986328125)
     (a = 0.2741504609584808349609375) (l2 = 0.479749381542205810546875)
     (l3 = 0.4983097016811370849609375) (l4 = 0.293364465236663818359375)
     (l5 = 0.2933644652366640404039799250313080847263336181640625)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: right } output C, P, E, DC, PE, FE; } }

twin! { twin_46, "rrr behind rrr", [theta: angle],
    [(gx = 0.46373951435089111328125) (gy = 0.0) (px = 0.000823223614133894443511962890625)
     (py = 0.1367719173431396484375) (fx = 0.24034745991230010986328125)
     (fy = 0.3491322696208953857421875) (a = 0.2826086580753326416015625)
     (l2 = 0.1851064264774322509765625) (l3 = 0.1788323819637298583984375)
     (l4 = 0.3032467365264892578125) (l5 = 0.3032466471195220947265625)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: right } output C, P, E, DC, PE, FE; } }

twin! { twin_47, "rrr behind rrr", [theta: angle],
    [(gx = 0.384118735790252685546875) (gy = 0.0) (px = 0.0192449204623699188232421875)
     (py = 0.11629514396190643310546875) (fx = -0.566439211368560791015625)
     (fy = -0.175642490386962890625) (a = 0.2884837687015533447265625) (l2 = 0.37250530719757080078125)
     (l3 = 0.367844402790069580078125) (l4 = 0.3025842010974884033203125)
     (l5 = 0.02569933421909809112548828125)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: left } output C, P, E, DC, PE, FE; } }

twin! { twin_48, "rrr behind rrr", [theta: angle],
    [(gx = 0.337827980518341064453125) (gy = -0.110889337956905364990234375)
     (px = 0.1822651922702789306640625) (py = -0.079723656177520751953125) (fx = 0.16429424285888671875)
     (fy = 0.330669581890106201171875) (a = 0.2081339657306671142578125)
     (l2 = 0.474405586719512939453125) (l3 = 0.487926781177520751953125)
     (l4 = 0.4001024663448333740234375) (l5 = 0.39340937137603759765625)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: right } output C, P, E, DC, PE, FE; } }

twin! { twin_49, "rrr behind rrr", [theta: angle],
    [(gx = 0.1926011145114898681640625) (gy = 0.18320286273956298828125)
     (px = -0.1389413177967071533203125) (py = 0.1961539089679718017578125)
     (fx = -0.4255408942699432373046875) (fy = -0.339545905590057373046875)
     (a = 0.271227061748504638671875) (l2 = 0.260986387729644775390625) (l3 = 0.352981507778167724609375)
     (l4 = 0.2701640427112579345703125) (l5 = 0.4793350994586944580078125)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: right } output C, P, E, DC, PE, FE; } }

twin! { twin_50, "rrr behind rrr", [theta: angle],
    [(gx = 0.20448772609233856201171875) (gy = 0.0) (px = -0.09524624049663543701171875)
     (py = -0.2498769462108612060546875) (fx = -0.55924904346466064453125)
     (fy = -0.09898753464221954345703125) (a = 0.19903041422367095947265625)
     (l2 = 0.3051370084285736083984375) (l3 = 0.2805836200714111328125)
     (l4 = 0.4153929054737091064453125) (l5 = 0.4153929054737093284899174250313080847263336181640625)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: right } output C, P, E, DC, PE, FE; } }

twin! { twin_51, "rrr behind rrr", [theta: angle],
    [(gx = 0.17000167071819305419921875) (gy = 0.12129680812358856201171875)
     (px = -0.2055582702159881591796875) (py = -0.259771525859832763671875)
     (fx = 0.51851117610931396484375) (fy = 0.17548505961894989013671875)
     (a = 0.2133066356182098388671875) (l2 = 0.280837714672088623046875)
     (l3 = 0.13729198276996612548828125) (l4 = 0.3522095382213592529296875)
     (l5 = 0.352209508419036865234375)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: left }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: left } output C, P, E, DC, PE, FE; } }

twin! { twin_52, "rrr behind rrr", [theta: angle],
    [(gx = 0.366935789585113525390625) (gy = 0.0) (px = -0.180433809757232666015625)
     (py = 0.122075594961643218994140625) (fx = -0.0457288734614849090576171875)
     (fy = -0.081380583345890045166015625) (a = 0.05019722878932952880859375)
     (l2 = 0.406088292598724365234375) (l3 = 0.261344850063323974609375)
     (l4 = 0.2807936966419219970703125) (l5 = 0.02218055538833141326904296875)],
    { ground A(0, 0), D(gx, gy), F(fx, fy); crank AB(A) -> B { length: a, angle: theta }
      rrr BC(B), DC(D) -> C { lengths: (l2, l3), mode: right }
      point P on BC at (px, py);
      rrr PE(P), FE(F) -> E { lengths: (l4, l5), mode: left } output C, P, E, DC, PE, FE; } }

twins! { loops:
    twin_03
    twin_06
    twin_09
    twin_12
    twin_15
    twin_18
    twin_21
    twin_24
    twin_27
    twin_30
    twin_33
    twin_36
    twin_39
    twin_42
    twin_43
    twin_44
    twin_45
    twin_46
    twin_47
    twin_48
    twin_49
    twin_50
    twin_51
    twin_52
}
