package org.dronewatch.fuzz;

import java.io.ByteArrayOutputStream;
import java.nio.charset.StandardCharsets;
import java.util.List;

/** Random damage to a file. */
final class ByteMutation {
    private static final List<String> SPLICES = List.of(
            "\0",
            "\uFEFF",
            "\n",
            "\r",
            "\\\n",
            "#",
            " ",
            "\t",
            "-",
            "/",
            "//",
            "1e155",
            "1e-300",
            "NaN",
            "-1",
            "0",
            "99999999",
            "4294967297",
            "\u001b[31m",
            "\u009b2J",
            "\u202E",
            "f 1 2 3\n",
            "v 0 0 0\n",
            "usemtl \n",
            "mtllib ../../x.mtl\n",
            "\u00A0",
            "\u2028",
            "\u0661",
            "'",
            "\"",
            ":",
            "{",
            "[",
            "*a",
            "&a",
            "!!x",
            "|",
            "%");

    private ByteMutation() {}

    /** The content with a few places changed. */
    static byte[] of(byte[] content, Dice dice) {
        byte[] changed = content;
        int places = dice.between(1, 6);
        for (int i = 0; i < places; i++) {
            changed = once(changed, dice);
        }
        return changed;
    }

    /**
     * A piece of a file, from the start of a line to the end of one, so that what is cut is small enough to be quick.
     */
    static String piece(String text, Dice dice, int lines) {
        String[] all = text.split("(?<=\n)");
        int from = dice.below(Math.max(1, all.length - lines));
        return String.join("", List.of(all).subList(from, Math.min(all.length, from + lines)));
    }

    private static byte[] once(byte[] content, Dice dice) {
        int length = content.length;
        int at = dice.below(length + 1);
        int to = Math.min(length, at + dice.between(1, dice.oneIn(5) ? 400 : 8));
        return switch (dice.below(6)) {
            case 0 -> replaced(content, at, to, new byte[0]);
            case 1 -> replaced(content, at, at, dice.pick(SPLICES).getBytes(StandardCharsets.UTF_8));
            case 2 -> replaced(content, at, to, dice.pick(SPLICES).getBytes(StandardCharsets.UTF_8));
            case 3 -> replaced(content, at, at, slice(content, dice.below(length + 1), 60));
            case 4 -> dice.oneIn(8) ? slice(content, 0, at) : replaced(content, at, at, slice(content, at, to - at));
            default -> {
                byte[] flipped = content.clone();
                if (at < length) {
                    flipped[at] ^= (byte) (1 << dice.below(8));
                }
                yield flipped;
            }
        };
    }

    private static byte[] slice(byte[] content, int from, int most) {
        int length = Math.min(most, content.length - from);
        byte[] slice = new byte[length];
        System.arraycopy(content, from, slice, 0, length);
        return slice;
    }

    private static byte[] replaced(byte[] content, int from, int to, byte[] by) {
        ByteArrayOutputStream result = new ByteArrayOutputStream(content.length + by.length);
        result.write(content, 0, from);
        result.writeBytes(by);
        result.write(content, to, content.length - to);
        return result.toByteArray();
    }
}
