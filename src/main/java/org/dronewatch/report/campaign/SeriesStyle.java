package org.dronewatch.report.campaign;

/**
 * The style of a variant, the same in all figures: a colour that can be distinguished with any colour vision, and
 * dashes.
 */
final class SeriesStyle {
    /** The number of variants that a figure shows; more would hide one another. */
    static final int MOST = 6;

    // Okabe and Ito, Color Universal Design, 2008.
    private static final String[] COLOURS = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#e69f00"};

    private SeriesStyle() {}

    static String colour(int number) {
        return COLOURS[number % COLOURS.length];
    }

    /** Lines differ in black and white, too: by their dashes. */
    static String stroke(int number) {
        String dashes = number == 0 ? "" : " stroke-dasharray=\"" + 4 * number + " 4\"";
        return "stroke=\"" + colour(number) + "\" stroke-width=\"2.5\"" + dashes;
    }
}
