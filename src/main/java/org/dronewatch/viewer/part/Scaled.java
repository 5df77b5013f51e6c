package org.dronewatch.viewer.part;

import com.formdev.flatlaf.util.UIScale;
import java.awt.Component;
import java.awt.Dimension;
import java.awt.Font;
import javax.swing.UIManager;

/**
 * Sizes on screens of any density. The graphics that components paint with already apply the scale factor of the
 * system; this class applies that of the user, who may choose a larger font or set {@code -Dflatlaf.uiScale}.
 */
public final class Scaled {
    private static final Font FALLBACK = new Font(Font.SANS_SERIF, Font.PLAIN, 12);

    private Scaled() {}

    /** Converts a length on a screen of normal density to Swing's pixels. */
    public static int px(int normal) {
        return UIScale.scale(normal);
    }

    /** Converts a size on a screen of normal density to Swing's pixels. */
    public static Dimension size(int width, int height) {
        return new Dimension(px(width), px(height));
    }

    /** The user's scale factor, without that of the system. */
    public static double factor() {
        return UIScale.getUserScaleFactor();
    }

    /** The font of labels at a fraction of its size. */
    public static Font font(double fraction) {
        return derived("Label.font", FALLBACK, fraction);
    }

    /** A font in which columns line up, at a fraction of its size. */
    public static Font monospaced(double fraction) {
        return derived("monospaced.font", new Font(Font.MONOSPACED, Font.PLAIN, px(12)), fraction);
    }

    private static Font derived(String key, Font otherwise, double fraction) {
        Font font = UIManager.getFont(key);
        Font base = font == null ? otherwise : font;
        return base.deriveFont((float) (base.getSize2D() * fraction));
    }

    /** The number of screen pixels per Swing pixel, along one axis, where a component is shown. */
    public static double density(Component part) {
        return part.getGraphicsConfiguration() == null
                ? 1.0
                : part.getGraphicsConfiguration().getDefaultTransform().getScaleX();
    }
}
