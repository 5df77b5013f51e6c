package org.dronewatch.viewer.part;

import javax.swing.Action;
import javax.swing.JMenuItem;

/**
 * A menu item whose keyboard shortcut takes effect at once: Swing's own item blocks the event thread while it shows
 * itself pressed.
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
