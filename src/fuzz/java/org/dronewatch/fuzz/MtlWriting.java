package org.dronewatch.fuzz;

import java.nio.charset.StandardCharsets;
import java.util.List;

/** Random MTL files. */
final class MtlWriting {
    private static final List<String> LINES = List.of(
            "newmtl a",
            "newmtl b",
            "newmtl",
            "newmtl \u001b[31mred",
            "newmtl a",
            "Kd 0.1 0.2 0.3",
            "Kd 2 -1 nan",
            "Kd",
            "Kd x y z",
            "Kd 1",
            "Ka 0 0 0",
            "Ns 10",
            "d 1",
            "Tr 0.0",
            "illum 2",
            "illum x",
            "map_Kd tex.png",
            "map_Kd -s 1 1",
            "map_Kd -o",
            "# comment",
            "",
            "Ke 1 1 1",
            "Ni 1.45",
            "bump -bm",
            "nonsense \u202E",
            "\\",
            "refl -type sphere x",
            "Kd spectral x.rfl 1",
            "Kd xyz 1 1 1",
            "norm",
            "Pr 0.5");

    private MtlWriting() {}

    static byte[] file(Dice dice) {
        StringBuilder text = new StringBuilder();
        for (int i = dice.below(14); i > 0; i--) {
            text.append(dice.pick(LINES)).append(dice.pick("\n", "\n", "\n", "\r\n"));
        }
        byte[] bytes = text.toString().getBytes(StandardCharsets.UTF_8);
        return dice.oneIn(4) ? ByteMutation.of(bytes, dice) : bytes;
    }

    /** The materials of {@code materials:COUNT}. */
    static byte[] many(int count) {
        StringBuilder text = new StringBuilder();
        for (int i = 0; i < count; i++) {
            text.append("newmtl m").append(i).append("\nKd 0.5 0.5 0.5\n");
        }
        return text.toString().getBytes(StandardCharsets.UTF_8);
    }
}
