package org.dronewatch.viewer.part;

import javax.swing.Action;
import javax.swing.JMenuItem;

/**
 * An entry of a menu whose key works at once: Swing's own holds up the event thread to show how the entry is pressed.
 */
public final class QuickItem extends JMenuItem {
    private static final long serialVersionUID = 1L;

    public QuickItem(Action action) {
        super(action);
    }

    @Override
    public void doClick(int pressTime) {
        super.doClick(0);
    }
}
