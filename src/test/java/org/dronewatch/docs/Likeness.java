package org.dronewatch.docs;

import java.awt.Font;
import java.awt.font.FontRenderContext;
import java.awt.image.BufferedImage;
import java.util.Locale;
import java.util.Optional;

/**
 * Whether two pictures show the same to the eye. Means over cells are compared, which rounding hardly changes. Where
 * letters are those of another font, more may differ: they take other room, and what stands beside them moves.
 */
enum Likeness {
    /** With the letters of the same font. */
    SAME_FONT(8.0, 0.001, 0.0005),
    /** Letters, labels and legends may look otherwise. */
    OTHER_FONT(16.0, 0.04, 0.004);

    /** The font with which the pictures in the pages are drawn. */
    private static final String FONT = "DejaVu Sans";

    /** Side of a cell, pixels. */
    private static final int CELL = 16;
    /** A cell is another altogether from such a difference of a colour on, of 255. */
    private static final double CLEARLY = 60.0;

    /** A cell is another from such a difference of a colour on, of 255. */
    private final double other;

    private final double mostOther;
    private final double mostClearly;

    Likeness(double other, double mostOther, double mostClearly) {
        this.other = other;
        this.mostOther = mostOther;
        this.mostClearly = mostClearly;
    }

    /** How alike a picture that is drawn here can be to those in the pages. */
    static Likeness here() {
        Font known = new Font(FONT, Font.PLAIN, 100);
        boolean same =
                known.getFamily().equals(FONT) && width(known) == width(new Font(Font.SANS_SERIF, Font.PLAIN, 100));
        return same ? SAME_FONT : OTHER_FONT;
    }

    private static double width(Font font) {
        FontRenderContext context = new FontRenderContext(null, true, true);
        return font.getStringBounds("Wide or narrow: 0123456789", context).getWidth();
    }

    /** What is different, in words; empty when nothing is. */
    Optional<String> difference(BufferedImage one, BufferedImage another) {
        if (one.getWidth() != another.getWidth() || one.getHeight() != another.getHeight()) {
            return Optional.of(size(one) + " against " + size(another) + " pixels");
        }
        int columns = (one.getWidth() + CELL - 1) / CELL;
        int rows = (one.getHeight() + CELL - 1) / CELL;
        int others = 0;
        int clearly = 0;
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                double difference = difference(mean(one, column, row), mean(another, column, row));
                others += difference > other ? 1 : 0;
                clearly += difference > CLEARLY ? 1 : 0;
            }
        }
        double cells = (double) rows * columns;
        return others <= mostOther * cells && clearly <= mostClearly * cells
                ? Optional.empty()
                : Optional.of(String.format(
                        Locale.ROOT, "%d of %.0f cells differ, %d of them altogether", others, cells, clearly));
    }

    private static String size(BufferedImage image) {
        return image.getWidth() + " x " + image.getHeight();
    }

    private static double difference(double[] one, double[] another) {
        double largest = 0.0;
        for (int i = 0; i < one.length; i++) {
            largest = Math.max(largest, Math.abs(one[i] - another[i]));
        }
        return largest;
    }

    /** The mean red, green and blue of a cell. */
    private static double[] mean(BufferedImage image, int column, int row) {
        int right = Math.min(image.getWidth(), (column + 1) * CELL);
        int bottom = Math.min(image.getHeight(), (row + 1) * CELL);
        double[] sum = new double[3];
        int pixels = 0;
        for (int y = row * CELL; y < bottom; y++) {
            for (int x = column * CELL; x < right; x++) {
                int colour = image.getRGB(x, y);
                sum[0] += colour >> 16 & 0xff;
                sum[1] += colour >> 8 & 0xff;
                sum[2] += colour & 0xff;
                pixels++;
            }
        }
        for (int i = 0; i < sum.length; i++) {
            sum[i] /= pixels;
        }
        return sum;
    }
}
