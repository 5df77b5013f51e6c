package org.dronewatch.viewer;

import java.util.Locale;
import java.util.Optional;
import javax.swing.Action;
import javax.swing.Box;
import javax.swing.JLabel;
import javax.swing.JSlider;
import javax.swing.JToolBar;
import org.dronewatch.geometry.AABB;
import org.dronewatch.render.canvas.Cut;
import org.dronewatch.viewer.part.Scaled;

/** Selects the viewpoint of the site and the height at which it is cut open. */
final class WorldBar extends JToolBar {
    private static final long serialVersionUID = 1L;
    private static final int STEPS = 500;

    private final transient WorldPanel world;
    private final JSlider slider = new JSlider(0, STEPS, STEPS);
    private final JLabel height = new JLabel("off");
    private double low;
    private double high = 1.0;
    private boolean updating;

    WorldBar(WorldPanel world, Action... views) {
        this.world = world;
        setFloatable(false);
        for (Action view : views) {
            add(view).setFocusable(false);
        }
        add(Box.createHorizontalGlue());
        add(new JLabel("Hide above "));
        slider.setMaximumSize(Scaled.size(180, 40));
        slider.setPreferredSize(Scaled.size(130, 24));
        slider.setToolTipText(
                "Hides everything above this height to reveal interiors; drag all the way to the right to show everything");
        slider.getAccessibleContext().setAccessibleName("cut height");
        slider.addChangeListener(e -> {
            if (!updating) {
                cut();
            }
        });
        add(slider);
        height.setPreferredSize(Scaled.size(62, 20));
        add(height);
    }

    /** Takes another site, with its initial cut. */
    void show(AABB bounds, Optional<Cut> cut) {
        low = bounds.minZ();
        high = bounds.maxZ();
        updating = true;
        slider.setValue(cut.map(c -> (int) Math.round(STEPS * (c.offset() - low) / (high - low)))
                .orElse(STEPS));
        updating = false;
        showHeight();
    }

    private void cut() {
        boolean whole = slider.getValue() == STEPS;
        world.setCut(whole ? Optional.empty() : Optional.of(Cut.above(chosen())));
        showHeight();
    }

    private double chosen() {
        return low + slider.getValue() * (high - low) / STEPS;
    }

    private void showHeight() {
        height.setText(slider.getValue() == STEPS ? "off" : String.format(Locale.ROOT, "%.1f m", chosen()));
    }
}
