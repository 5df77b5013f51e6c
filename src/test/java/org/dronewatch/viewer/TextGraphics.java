package org.dronewatch.viewer;

import java.awt.Color;
import java.awt.FontMetrics;
import java.awt.Graphics;
import java.awt.Graphics2D;
import java.awt.Rectangle;
import java.awt.font.GlyphVector;
import java.awt.geom.Rectangle2D;
import java.awt.image.BufferedImage;
import java.text.AttributedCharacterIterator;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;

/**
 * Paints into an image everything but texts, which it lists with their contrast to what has been painted there. The
 * viewer draws plain strings only: whoever draws texts otherwise has to measure them here, and is refused until then.
 */
final class TextGraphics extends ForwardingGraphics {
    /** The share of pixels behind a text that may have less contrast: edges of what is beside it. */
    private static final double TOLERATED = 0.1;

    /**
     * A text.
     *
     * @param at where it is in the image, pixels
     * @param contrast the contrast ratio of WCAG 2.1, 1 to 21
     */
    record Text(String text, Rectangle at, Color colour, double contrast) {}

    private final Graphics2D g;
    private final BufferedImage image;
    private final List<Text> texts;

    TextGraphics(BufferedImage image) {
        this(image.createGraphics(), image, new ArrayList<>());
    }

    private TextGraphics(Graphics2D g, BufferedImage image, List<Text> texts) {
        super(g);
        this.g = g;
        this.image = image;
        this.texts = texts;
    }

    /** The texts so far. */
    List<Text> texts() {
        return texts;
    }

    /** The contrast ratio of two opaque colours. */
    static double contrast(Color one, Color other) {
        double a = luminance(one);
        double b = luminance(other);
        return (Math.max(a, b) + 0.05) / (Math.min(a, b) + 0.05);
    }

    private static double luminance(Color colour) {
        return 0.2126 * linear(colour.getRed())
                + 0.7152 * linear(colour.getGreen())
                + 0.0722 * linear(colour.getBlue());
    }

    private static double linear(int value) {
        double share = value / 255.0;
        return share <= 0.04045 ? share / 12.92 : Math.pow((share + 0.055) / 1.055, 2.4);
    }

    private void add(String text, double x, double y) {
        FontMetrics metrics = g.getFontMetrics();
        Rectangle2D own = new Rectangle2D.Double(
                x, y - metrics.getAscent(), metrics.stringWidth(text), metrics.getAscent() + metrics.getDescent());
        Rectangle2D seen =
                g.getClip() == null ? own : own.createIntersection(g.getClip().getBounds2D());
        Rectangle at = g.getTransform().createTransformedShape(seen).getBounds();
        at = at.intersection(new Rectangle(image.getWidth(), image.getHeight()));
        if (text.isBlank() || seen.isEmpty() || at.isEmpty()) {
            return;
        }
        double[] contrasts = new double[at.width * at.height];
        for (int i = 0; i < contrasts.length; i++) {
            Color behind = new Color(image.getRGB(at.x + i % at.width, at.y + i / at.width));
            contrasts[i] = contrast(over(g.getColor(), behind), behind);
        }
        Arrays.sort(contrasts);
        texts.add(new Text(text, at, g.getColor(), contrasts[(int) (TOLERATED * contrasts.length)]));
    }

    private static Color over(Color colour, Color behind) {
        double share = colour.getAlpha() / 255.0;
        return new Color(
                (int) Math.rint(share * colour.getRed() + (1.0 - share) * behind.getRed()),
                (int) Math.rint(share * colour.getGreen() + (1.0 - share) * behind.getGreen()),
                (int) Math.rint(share * colour.getBlue() + (1.0 - share) * behind.getBlue()));
    }

    @Override
    public void drawString(String text, int x, int y) {
        add(text, x, y);
    }

    @Override
    public void drawString(String text, float x, float y) {
        add(text, x, y);
    }

    @Override
    public void drawString(AttributedCharacterIterator text, int x, int y) {
        throw new UnsupportedOperationException("the contrast of attributed text is not measured");
    }

    @Override
    public void drawString(AttributedCharacterIterator text, float x, float y) {
        throw new UnsupportedOperationException("the contrast of attributed text is not measured");
    }

    @Override
    public void drawGlyphVector(GlyphVector glyphs, float x, float y) {
        throw new UnsupportedOperationException("the contrast of glyphs is not measured");
    }

    @Override
    public Graphics create() {
        return new TextGraphics((Graphics2D) g.create(), image, texts);
    }
}
