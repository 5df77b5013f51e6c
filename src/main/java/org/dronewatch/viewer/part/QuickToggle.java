package org.dronewatch.viewer.part;

import javax.swing.JCheckBoxMenuItem;

/** An entry with a tick whose key works at once, as that of {@link QuickItem}. */
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
