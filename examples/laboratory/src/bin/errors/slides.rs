// Written by `draw_mechanisms slides` of this package, which says how.

twin! { twin_53, "rrp", [theta: angle],
    [(ax = 0.2968623638153076171875) (ay = 0.19234979152679443359375) (kx = 0.0) (ky = 0.0)
     (a = 0.17166428267955780029296875) (l = 0.68379323184490203857421875) (e = 0.0) (tilt = 0.0)],
    { ground A(ax, ay); guide rail through (kx, ky) along tilt;
      crank AB(A) -> B { length: a, angle: theta }
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: ahead } output C, BC, ram.slide; } }

twin! { twin_54, "rrp between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.15115971863269805908203125) (gy = 0.036641336977481842041015625)
     (kx = -0.08585260808467864990234375) (ky = -0.000666642212308943271636962890625)
     (a = 0.12957286834716796875) (l = 0.9415498673915863037109375) (e = 0.0)
     (tilt = 0.70205605030059814453125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank arm(D) { angle: phi } guide rail on arm through (kx, ky) along tilt;
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: ahead } output C, BC, ram.slide; } }

twin! { twin_55, "rpr", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.094157993793487548828125) (gy = -0.2427871525287628173828125)
     (a = 0.169739663600921630859375) (px = 0.115997292101383209228515625)
     (py = 0.08971746265888214111328125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rpr block(B), rod(D) { mode: behind }
      point P on rod at (px, py); output P, rod, block.slide; } }

twin! { twin_56, "rpr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.6712954044342041015625) (gy = -0.0924300849437713623046875)
     (a = 0.196700513362884521484375) (b = 0.044862411916255950927734375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rpr block(B), rod(E) { mode: ahead } output rod, block.slide; } }

twin! { twin_57, "prp", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.229068577289581298828125) (gy = -0.008578240871429443359375)
     (a = 0.036841146647930145263671875) (tilt = 0.4987315237522125244140625)
     (e1 = -0.069244660437107086181640625) (e2 = 0.0601187236607074737548828125)
     (turn = 0.72425591945648193359375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      guide slot on AB through B along turn; crank arm(D) { angle: phi } guide post on arm through (0, a) along tilt;
      prp shoe(slot), ram(post) -> C { offsets: (e1, e2) } output C, shoe.slide, ram.slide; } }

twin! { twin_58, "rpp", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.11761033535003662109375) (gy = 0.081375740468502044677734375)
     (a = 0.205795764923095703125) (tilt = 2.05914020538330078125) (e1 = -0.0512011051177978515625)
     (e2 = -0.009631574153900146484375) (across = 0.719709694385528564453125)],
    { ground A(ax, ay); crank AB(A) -> B { length: a, angle: theta } guide rail through (gx, gy) along tilt;
      rpp block(B), ram(rail) { slot: across, offsets: (e1, e2) }
      output block, ram.slide; } }

twin! { twin_59, "rrp", [theta: angle],
    [(ax = -0.058475494384765625) (ay = -0.060634136199951171875) (kx = 0.004024505615234375)
     (ky = -0.091884136199951171875) (a = 0.12980978190898895263671875)
     (l = 0.47549046576023101806640625) (e = -0.0233092196285724639892578125)
     (tilt = 0.3926732540130615234375)],
    { ground A(ax, ay); guide rail through (kx, ky) along tilt;
      crank AB(A) -> B { length: a, angle: theta }
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: ahead } output C, BC, ram.slide; } }

twin! { twin_60, "rrp between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.072988577187061309814453125) (gy = 0.086569927632808685302734375)
     (kx = -0.080490566790103912353515625) (ky = -0.0572028867900371551513671875)
     (a = 0.14485551416873931884765625) (l = 0.74265573918819427490234375)
     (e = -0.075439952313899993896484375) (tilt = -1.3653366565704345703125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank arm(D) { angle: phi } guide rail on arm through (kx, ky) along tilt;
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: behind } output C, BC, ram.slide; } }

twin! { twin_61, "rpr", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.081568472087383270263671875) (gy = -0.01432734169065952301025390625)
     (a = 0.2345843017101287841796875) (px = 0.21344654262065887451171875)
     (py = 0.16629858314990997314453125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rpr block(B), rod(D) { mode: behind }
      point P on rod at (px, py); output P, rod, block.slide; } }

twin! { twin_62, "rpr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = -0.0044861473143100738525390625) (gy = -0.0307928435504436492919921875)
     (a = 0.064405687153339385986328125) (b = 0.0237487293779850006103515625)
     (e = 0.027813144028186798095703125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rpr block(B), rod(E) { offset: e, mode: ahead } output rod, block.slide; } }

twin! { twin_63, "prp", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.2817431986331939697265625) (gy = 0.059203803539276123046875)
     (a = 0.23220737278461456298828125) (tilt = 1.32056796550750732421875)
     (e1 = 0.0000927686705836094915866851806640625) (e2 = 0.035402633249759674072265625)
     (turn = 0.3300880491733551025390625)],
    { ground A(ax, ay); crank AB(A) -> B { length: a, angle: theta }
      guide slot on AB through B along turn; guide post through (gx, gy) along tilt;
      prp shoe(slot), ram(post) -> C { offsets: (e1, e2) } output C, shoe.slide, ram.slide; } }

twin! { twin_64, "rpp", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.13137567043304443359375) (gy = -0.08142735064029693603515625)
     (a = 0.0330172441899776458740234375) (tilt = 2.7754690647125244140625)
     (e1 = 0.084665678441524505615234375) (e2 = -0.072923183441162109375)
     (across = 0.6244266033172607421875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta } crank arm(D) { angle: phi } guide rail on arm through (0, a) along tilt;
      rpp block(B), ram(rail) { slot: across, offsets: (e1, e2) }
      output block, ram.slide; } }

twin! { twin_65, "rrp", [theta: angle],
    [(ax = 0.085537970066070556640625) (ay = -0.30497896671295166015625)
     (kx = 0.148037970066070556640625) (ky = -0.33622896671295166015625)
     (a = 0.0544181801378726959228515625) (l = 0.0544181801378726959228515625)
     (e = -0.099924169480800628662109375) (tilt = -2.2512638568878173828125)],
    { ground A(ax, ay); guide rail through (kx, ky) along tilt;
      crank AB(A) -> B { length: a, angle: theta }
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: ahead } output C, BC, ram.slide; } }

twin! { twin_66, "rrp between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.10620544850826263427734375) (gy = -0.09165133535861968994140625)
     (kx = -0.051676474511623382568359375) (ky = 0.083019219338893890380859375)
     (a = 0.283994376659393310546875) (l = 0.533994376659393310546875)
     (e = 0.078375436365604400634765625) (tilt = -2.56761074066162109375)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank arm(D) { angle: phi } guide rail on arm through (kx, ky) along tilt;
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: behind } output C, BC, ram.slide; } }

twin! { twin_67, "rpr", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = -0.153714001178741455078125) (gy = 0.0376281030476093292236328125)
     (a = 0.157218396663665771484375) (px = 0.301407158374786376953125)
     (py = 0.0191631801426410675048828125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rpr block(B), rod(D) { mode: ahead }
      point P on rod at (px, py); output P, rod, block.slide; } }

twin! { twin_68, "rpr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.02845655195415019989013671875) (gy = 0.0298495031893253326416015625)
     (a = 0.0411440469324588775634765625) (b = 0.01306016929447650909423828125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rpr block(B), rod(E) { mode: ahead } output rod, block.slide; } }

twin! { twin_69, "prp", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.3015480935573577880859375) (gy = -0.0345524065196514129638671875)
     (a = 0.16003744304180145263671875) (tilt = 2.6185572147369384765625)
     (e1 = -0.0281644575297832489013671875) (e2 = -0.085513137280941009521484375)
     (turn = 0.278054535388946533203125)],
    { ground A(ax, ay); crank AB(A) -> B { length: a, angle: theta }
      guide slot on AB through B along turn; guide post through (gx, gy) along tilt;
      prp shoe(slot), ram(post) -> C { offsets: (e1, e2) } output C, shoe.slide, ram.slide; } }

twin! { twin_70, "rpp", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.2637967169284820556640625) (gy = 0.068591080605983734130859375)
     (a = 0.2246662676334381103515625) (tilt = 1.24306905269622802734375)
     (e1 = -0.086204707622528076171875) (e2 = 0.097437836229801177978515625)
     (across = 0.360125005245208740234375)],
    { ground A(ax, ay); crank AB(A) -> B { length: a, angle: theta } guide rail through (gx, gy) along tilt;
      rpp block(B), ram(rail) { slot: across, offsets: (e1, e2) }
      output block, ram.slide; } }

twin! { twin_71, "rrp", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (kx = 0.0625) (ky = -0.03125) (a = 0.08369491994380950927734375)
     (l = 0.21803207695484161376953125) (e = 0.2180102765560150146484375)
     (tilt = -1.15892064571380615234375)],
    { ground A(ax, ay); guide rail through (kx, ky) along tilt;
      crank AB(A) -> B { length: a, angle: theta }
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: ahead } output C, BC, ram.slide; } }

twin! { twin_72, "rrp between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.11111389100551605224609375) (gy = 0.06483833491802215576171875)
     (kx = 0.06692712008953094482421875) (ky = 0.099609278142452239990234375)
     (a = 0.2798335850238800048828125) (l = 0.7495284974575042724609375)
     (e = 0.4994785487651824951171875) (tilt = 0.078917026519775390625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank arm(D) { angle: phi } guide rail on arm through (kx, ky) along tilt;
      rrp BC(B), ram(rail) -> C { length: l, offset: e, mode: ahead } output C, BC, ram.slide; } }

twin! { twin_73, "rpr", [theta: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.406683862209320068359375) (gy = -0.088276565074920654296875)
     (a = 0.16856999695301055908203125) (px = 0.4137041866779327392578125)
     (py = 0.08588667213916778564453125) (e = 0.1100887954235076904296875)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      rpr block(B), rod(D) { offset: e, mode: ahead }
      point P on rod at (px, py); output P, rod, block.slide; } }

twin! { twin_74, "rpr between cranks", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.01905366219580173492431640625) (gy = -0.410068929195404052734375)
     (a = 0.18968771398067474365234375) (b = 0.032028384506702423095703125)
     (e = 0.05956704914569854736328125)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      crank DE(D) -> E { length: b, angle: phi }
      rpr block(B), rod(E) { offset: e, mode: behind } output rod, block.slide; } }

twin! { twin_75, "prp", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.227684438228607177734375) (gy = 0.09209732711315155029296875)
     (a = 0.097918987274169921875) (tilt = 2.6041338443756103515625) (e1 = 0.079798780381679534912109375)
     (e2 = -0.029502689838409423828125) (turn = 0.5144748687744140625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta }
      guide slot on AB through B along turn; crank arm(D) { angle: phi } guide post on arm through (0, a) along tilt;
      prp shoe(slot), ram(post) -> C { offsets: (e1, e2) } output C, shoe.slide, ram.slide; } }

twin! { twin_76, "rpp", [theta: angle, phi: angle],
    [(ax = 0.0) (ay = 0.0) (gx = 0.074137799441814422607421875) (gy = 0.09530805051326751708984375)
     (a = 0.24906919896602630615234375) (tilt = -1.89326727390289306640625)
     (e1 = -0.088757239282131195068359375) (e2 = -0.015082836151123046875)
     (across = 0.072998441755771636962890625)],
    { ground A(ax, ay), D(gx, gy); crank AB(A) -> B { length: a, angle: theta } crank arm(D) { angle: phi } guide rail on arm through (0, a) along tilt;
      rpp block(B), ram(rail) { slot: across, offsets: (e1, e2) }
      output block, ram.slide; } }

twins! { slides:
    twin_53
    twin_54
    twin_55
    twin_56
    twin_57
    twin_58
    twin_59
    twin_60
    twin_61
    twin_62
    twin_63
    twin_64
    twin_65
    twin_66
    twin_67
    twin_68
    twin_69
    twin_70
    twin_71
    twin_72
    twin_73
    twin_74
    twin_75
    twin_76
}
