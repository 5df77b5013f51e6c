package org.dronewatch.viewer.part;

import java.awt.BorderLayout;
import java.awt.Component;
import javax.swing.JPanel;
import javax.swing.JSplitPane;

/** Arranges parts of the window beside and below each other. */
public final class Divided {
    private Divided() {}

    /**
     * Two parts with a divider between them.
     *
     * @param orientation orientation of the {@link JSplitPane}
     * @param weight fraction of additional space that the first part receives when the window grows, 0 to 1
     */
    public static JSplitPane split(int orientation, Component first, Component second, double weight) {
        JSplitPane pane = new JSplitPane(orientation, first, second);
        pane.setResizeWeight(weight);
        return pane;
    }

    /** One part, and another below it at the preferred height of the latter. */
    public static JPanel below(Component first, Component second) {
        JPanel panel = new JPanel(new BorderLayout());
        panel.add(first, BorderLayout.CENTER);
        panel.add(second, BorderLayout.SOUTH);
        return panel;
    }
}
