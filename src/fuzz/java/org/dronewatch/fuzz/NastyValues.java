package org.dronewatch.fuzz;

import java.util.List;

/** Values that a person might write, or that somebody might write on purpose. */
final class NastyValues {
    private static final List<String> NUMBERS = List.of(
            "0",
            "-0",
            "-0.0",
            "1",
            "-1",
            "0.5",
            "1e155",
            "-1e155",
            "1e-155",
            "1e300",
            "-1e300",
            "1e-300",
            "1e308",
            "1.8e308",
            "1e309",
            "4.9e-324",
            "1e-400",
            "1e38",
            "3.5e38",
            "1e30",
            "1e39",
            "1e20",
            "1e15",
            "1e-15",
            "1e9",
            "1e7",
            "100000",
            "-100000",
            "16384",
            "2147483647",
            "2147483648",
            "-2147483648",
            "9223372036854775807",
            "9223372036854775808",
            "1e999999999",
            "0.1",
            "0.30000000000000004",
            "3.141592653589793",
            "3.141592653589792",
            "1.5707963267948966");

    private static final List<String> UNITS = List.of(
            " m",
            " km",
            " deg",
            " rad",
            " dB",
            " Hz",
            " kHz",
            " s",
            " h",
            " day",
            " m/s",
            " km/h",
            " kg",
            " %",
            " K",
            " degC",
            " degF",
            " Pa",
            " hPa",
            " m2",
            " W",
            " mW",
            " px",
            " ly",
            " pc",
            " AU",
            " um",
            " mm/h",
            " lx",
            " furlong",
            " m2/s",
            "m",
            " M",
            " MHz",
            " grad",
            " arcsec",
            " Gm",
            " m/s/s");

    private static final List<String> WORDS = List.of(
            "",
            " ",
            "NaN",
            "nan",
            ".nan",
            "Infinity",
            "-Infinity",
            "inf",
            ".inf",
            "0x10",
            "0x1p3",
            "1f",
            "1d",
            "1L",
            "1_000",
            "1,000",
            "1,5",
            "\u0661\u0662\u0663",
            "\uFF11\uFF12",
            "\u00BD",
            "\u221E",
            "1e",
            "e5",
            "--1",
            "+-1",
            "+1",
            ".5",
            "5.",
            ".",
            "true",
            "no",
            "null",
            "~",
            "1:30",
            "0o17",
            "1 2",
            "1 m m",
            "m",
            "%",
            "[1, 2, 3]",
            "[1e155, 0, 0]",
            "1, 2, 3",
            "{a: 1}",
            "*a",
            "!!x y",
            "../../x",
            "packaged:hill.obj",
            "packaged:../x",
            "kind",
            "camera",
            "energy-model",
            "level-model",
            "=",
            "a=b",
            "'",
            "\"",
            "\\",
            "$HOME",
            "${x}",
            "%s",
            "%n",
            "{0}",
            "\u001b[31m",
            "\u0007",
            "a\nb",
            "a\tb",
            "a\rb",
            "\u009b31m",
            "\u202Eabc",
            "\u2028",
            "\0",
            "\uD800",
            "blighter-a400",
            "viper",
            "autonomous");

    private NastyValues() {}

    /** A value, mostly a number. */
    static String any(Dice dice) {
        return switch (dice.below(10)) {
            case 0, 1, 2, 3, 4 -> dice.pick(NUMBERS);
            case 5, 6 -> dice.pick(NUMBERS) + dice.pick(UNITS);
            case 7 -> "" + dice.random().nextDouble() * Math.pow(10, dice.between(-3, 4));
            case 8 -> dice.pick(WORDS);
            default ->
                dice.oneIn(3) ? dice.pick("Q", "9", "\u00E9", "[").repeat(dice.between(100, 5000)) : dice.pick(WORDS);
        };
    }

    /** A number of any size: every third one very small, every third one very large. */
    static String magnitude(Dice dice) {
        int exponent =
                switch (dice.below(3)) {
                    case 0 -> dice.between(-323, -4);
                    case 1 -> dice.between(4, 308);
                    default -> dice.between(-3, 3);
                };
        return (dice.oneIn(8) ? "-" : "") + dice.between(1, 9) + "e" + exponent;
    }

    /** A name, mostly with something in it that a terminal would obey. */
    static String name(Dice dice) {
        return switch (dice.below(4)) {
            case 0 -> "Q".repeat(dice.between(100, 3000));
            case 1 -> dice.pick(WORDS);
            default ->
                dice.several(
                        dice.between(1, 4),
                        List.of(
                                "a",
                                "x.y",
                                "\u001b]0;pwned\u0007",
                                "\u001b[2J",
                                "\u009b31m",
                                "\u202E",
                                "\r",
                                "\b",
                                "\u007f",
                                "'",
                                " ",
                                "/",
                                "..",
                                "\u0085",
                                "\u2028",
                                "\u5BB6",
                                "\uD83D\uDE81",
                                "<b>",
                                "&amp;",
                                ",",
                                "=",
                                "\"",
                                "\n",
                                "\t",
                                "\0",
                                "%n",
                                "*"));
        };
    }
}
