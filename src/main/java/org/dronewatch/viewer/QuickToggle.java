package org.dronewatch.viewer;

import javax.swing.JCheckBoxMenuItem;

/** An entry with a tick whose key works at once, as that of {@link QuickItem}. */
final class QuickToggle extends JCheckBoxMenuItem {
    private static final long serialVersionUID = 1L;

    QuickToggle(String name, boolean on) {
        super(name, on);
    }

    @Override
    public void doClick(int pressTime) {
        super.doClick(0);
    }
}
