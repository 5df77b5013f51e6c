package org.dronewatch.report.coverage;

import java.awt.Color;
import java.util.EnumMap;
import java.util.Map;
import org.dronewatch.report.sheet.ColourMix;
import org.dronewatch.report.sheet.MapSheet;
import org.dronewatch.report.sheet.Tint;
import org.dronewatch.sensor.Cause;

/**
 * The appearance of causes on a map. The colours are from the palette of Okabe and Ito ("Color Universal Design",
 * 2008), which people with any kind of colour vision can distinguish; patterns distinguish the causes in black and
 * white. Every cause except {@link Cause#DETECTED} has a pattern, since lightness alone does not identify a colour on a
 * shaded slope.
 */
public final class CauseFills {
    private static final Color LIGHT_BLUE = new Color(0x9fd3f2);
    private static final Color YELLOW = new Color(0xf0e442);
    private static final Color ORANGE = new Color(0xe69f00);
    private static final Color VERMILION = new Color(0xd55e00);
    private static final Color GREEN = new Color(0x009e73);
    private static final Color BLUE = new Color(0x0072b2);
    private static final Color PURPLE = new Color(0xcc79a7);
    private static final Color BROWN = new Color(0x7a5230);
    private static final Color GREY = new Color(0x9a9a9a);
    private static final Color DARK = new Color(0x4a4a4a);
    private static final double STRENGTH = 0.55;
    private static final double LINE_STRENGTH = 0.95;
    private static final int PERIOD = 8;

    /** The fill of a cell inside something solid: the ground, darkened. */
    public static final MapSheet.Fill INSIDE = (u, v, ground) -> ColourMix.of(ground, DARK, LINE_STRENGTH);

    /** A cell outside the area that counts: its ground, paler. */
    static final MapSheet.Fill OUTSIDE = (u, v, ground) -> ColourMix.of(ground, Color.WHITE, 0.5);

    /** A cell of which it is known only that it is open, since there is no sensor. */
    static final MapSheet.Fill NO_SENSOR = lined(GREY, (u, v) -> u % PERIOD < 2 && v % PERIOD < 2);

    /** A cell whose coverage is lost: the colour of what is detected, crossed out. */
    static final MapSheet.Fill LOST = (u, v, ground) -> (isCross(u, v) ? Color.BLACK : LIGHT_BLUE).getRGB();

    /** A cell in which a sensor detects the drone, but not with the probability, or within the time, asked for. */
    static final MapSheet.Fill TOO_RARELY = lined(LIGHT_BLUE, (u, v) -> (u + v) % PERIOD < 2);

    private static final Map<Cause, MapSheet.Fill> FILLS = new EnumMap<>(Cause.class);

    static {
        for (Cause cause : Cause.values()) {
            FILLS.put(cause, made(cause));
        }
    }

    private CauseFills() {}

    /** The plain colour of a cause, without its pattern. */
    static Color colour(Cause cause) {
        return switch (cause) {
            case UNKNOWN -> Color.WHITE;
            case OUT_OF_RANGE -> GREY;
            case OUT_OF_VIEW -> PURPLE;
            case SILENT -> ColourMix.of(PURPLE, Color.BLACK, 0.45);
            case TOO_SLOW -> ORANGE;
            case TOO_FAST -> ColourMix.of(ORANGE, Color.BLACK, 0.45);
            case HIDDEN_BY_TERRAIN -> BROWN;
            case HIDDEN_BY_BUILDING -> VERMILION;
            case HIDDEN_BY_VEGETATION -> GREEN;
            case HIDDEN_BY_OTHER -> BLUE;
            case TOO_WEAK -> YELLOW;
            case DETECTED -> LIGHT_BLUE;
        };
    }

    /** The colour of what is inside something solid. */
    static Color insideColour() {
        return DARK;
    }

    /** The colour of what is detected, but not with the probability, or within the time, asked for. */
    static Color tooRarelyColour() {
        return ColourMix.of(LIGHT_BLUE, Color.BLACK, 0.3);
    }

    /** The colour of a cause with its pattern. */
    static MapSheet.Fill of(Cause cause) {
        return FILLS.get(cause);
    }

    private static MapSheet.Fill made(Cause cause) {
        return switch (cause) {
            case UNKNOWN -> (u, v, ground) -> ColourMix.of(ground, (u + v) / 5 % 2 == 0 ? GREY : Color.WHITE, 0.75);
            case OUT_OF_RANGE -> lined(GREY, CauseFills::isPlus);
            case OUT_OF_VIEW -> lined(PURPLE, (u, v) -> u % PERIOD == 0);
            case SILENT -> lined(PURPLE, (u, v) -> u % PERIOD == 0 || v % PERIOD == 0);
            case TOO_SLOW -> lined(ORANGE, (u, v) -> v % PERIOD == 0);
            case TOO_FAST -> lined(ORANGE, (u, v) -> v % PERIOD == 0 && u % PERIOD < PERIOD / 2);
            case HIDDEN_BY_TERRAIN -> lined(BROWN, (u, v) -> (u + v) % PERIOD < 2);
            case HIDDEN_BY_BUILDING -> lined(VERMILION, (u, v) -> Math.floorMod(u - v, PERIOD) < 2);
            case HIDDEN_BY_VEGETATION -> lined(GREEN, (u, v) -> (u + v) % (2 * PERIOD) < 2);
            case HIDDEN_BY_OTHER -> lined(BLUE, (u, v) -> Math.floorMod(u - v, 2 * PERIOD) < 2);
            case TOO_WEAK -> lined(YELLOW, (u, v) -> u % PERIOD < 2 && v % PERIOD < 2);
            case DETECTED -> (u, v, ground) -> ColourMix.of(ground, LIGHT_BLUE, STRENGTH);
        };
    }

    /** Whether a pixel belongs to one of the plus signs in every other row and column of the patterns. */
    private static boolean isPlus(int u, int v) {
        int across = Math.abs(2 * Math.floorMod(u, 2 * PERIOD) - 2 * PERIOD + 1);
        int down = Math.abs(2 * Math.floorMod(v, 2 * PERIOD) - 2 * PERIOD + 1);
        return Math.min(across, down) == 1 && Math.max(across, down) < PERIOD;
    }

    private static boolean isCross(int u, int v) {
        return (u + v) % PERIOD < 2 || Math.floorMod(u - v, PERIOD) < 2;
    }

    /** Where the lines of a pattern are. */
    private interface Pattern {
        boolean isLine(int u, int v);
    }

    private static MapSheet.Fill lined(Color colour, Pattern pattern) {
        Tint line = new Tint(ColourMix.of(colour, Color.BLACK, 0.45), LINE_STRENGTH);
        Tint between = new Tint(colour, STRENGTH);
        return (u, v, ground) -> (pattern.isLine(u, v) ? line : between).over(ground);
    }
}
