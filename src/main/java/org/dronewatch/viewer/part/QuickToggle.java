package org.dronewatch.viewer.part;

import javax.swing.JCheckBoxMenuItem;

/** A check-box menu item whose keyboard shortcut takes effect at once, as that of {@link QuickItem} does. */
public final class QuickToggle extends JCheckBoxMenuItem {
    private static final long serialVersionUID = 1L;

    public QuickToggle(String name, boolean on) {
        super(name, on);
    }

    @Override
    public void doClick(int pressTime) {
        super.doClick(0);
    }
}
