package org.dronewatch.viewer;

import java.awt.event.KeyEvent;
import java.util.function.Consumer;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import org.dronewatch.picture.Orbit;

/** The menus, each entry with its key. */
final class ViewerMenus {
    /** One key press walks by this share of the distance to what is looked at. */
    private static final double STRIDE = 0.06;

    private final ViewerPane pane;
    private final Exports exports;
    private final Consumer<Boolean> darkChosen;
    private final Runnable closeChosen;

    ViewerMenus(ViewerPane pane, Exports exports, Consumer<Boolean> darkChosen, Runnable closeChosen) {
        this.pane = pane;
        this.exports = exports;
        this.darkChosen = darkChosen;
        this.closeChosen = closeChosen;
    }

    JMenuBar bar(boolean dark) {
        JMenuBar bar = new JMenuBar();
        bar.add(file());
        bar.add(run());
        bar.add(view());
        bar.add(window(dark));
        return bar;
    }

    private static JMenuItem item(String name, String explanation, KeyStroke key, Runnable work) {
        return new QuickItem(ViewerActions.action(name, explanation, key, work));
    }

    private JMenu file() {
        JMenu menu = new JMenu("File");
        menu.setMnemonic('F');
        menu.add(item(
                "Save picture of the site ...",
                "Writes the 3D view as PNG",
                ViewerActions.menuKey(KeyEvent.VK_S),
                () -> exports.savePicture(pane.world(), "site")));
        menu.add(item(
                "Save picture of the cameras ...",
                "Writes the cameras as they are shown as PNG",
                null,
                () -> exports.savePicture(pane.cameras(), "cameras")));
        menu.add(item(
                "Save picture of the time line ...",
                "Writes the time line as PNG",
                null,
                () -> exports.savePicture(pane.timeLine(), "time-line")));
        menu.add(item(
                "Save picture of the window ...",
                "Writes all of the window as PNG",
                ViewerActions.shiftedMenuKey(KeyEvent.VK_S),
                () -> exports.savePicture(pane, "window")));
        menu.add(item(
                "Save run as pictures ...",
                "Writes the whole run as numbered pictures of the site",
                ViewerActions.menuKey(KeyEvent.VK_E),
                exports::saveRun));
        menu.addSeparator();
        menu.add(item("Close", "Closes the window", ViewerActions.menuKey(KeyEvent.VK_W), closeChosen));
        return menu;
    }

    private JMenu run() {
        JMenu menu = new JMenu("Run");
        menu.setMnemonic('R');
        ViewerActions actions = pane.actions();
        menu.add(new QuickItem(actions.play()));
        menu.add(new QuickItem(actions.stepOn()));
        menu.add(new QuickItem(actions.stepBack()));
        menu.add(new QuickItem(actions.toStart()));
        menu.add(new QuickItem(actions.toEnd()));
        menu.addSeparator();
        menu.add(new QuickItem(actions.faster()));
        menu.add(new QuickItem(actions.slower()));
        menu.addSeparator();
        menu.add(item(
                "Trace rays of sound",
                "Follows all rays of the chosen microphone at the time shown",
                ViewerActions.key(KeyEvent.VK_R),
                pane.rayPanel()::trace));
        return menu;
    }

    private JMenu view() {
        JMenu menu = new JMenu("View");
        menu.setMnemonic('V');
        pane.views().forEach(view -> menu.add(new QuickItem(view)));
        menu.addSeparator();
        WorldPanel world = pane.world();
        menu.add(toggle("Names", 'N', shown -> world.setStyle(world.style().withLabels(shown))));
        menu.add(toggle(
                "Fields of view", 'O', shown -> world.setStyle(world.style().withOutlines(shown))));
        menu.add(toggle("Flights", 'L', shown -> world.setStyle(world.style().withFlights(shown))));
        menu.addSeparator();
        menu.add(item("Walk ahead", "Walks on the level", ViewerActions.key(KeyEvent.VK_W), () -> walk(1, 0)));
        menu.add(item("Walk back", "Walks on the level", ViewerActions.key(KeyEvent.VK_S), () -> walk(-1, 0)));
        menu.add(item("Walk left", "Walks on the level", ViewerActions.key(KeyEvent.VK_A), () -> walk(0, -1)));
        menu.add(item("Walk right", "Walks on the level", ViewerActions.key(KeyEvent.VK_D), () -> walk(0, 1)));
        menu.add(item("Nearer", "Zooms in", ViewerActions.key(KeyEvent.VK_PAGE_UP), () -> zoom(0.8)));
        menu.add(item("Farther", "Zooms out", ViewerActions.key(KeyEvent.VK_PAGE_DOWN), () -> zoom(1.25)));
        menu.addSeparator();
        menu.add(item(
                "All cameras",
                "Shows all cameras side by side",
                ViewerActions.key(KeyEvent.VK_ESCAPE),
                () -> pane.cameras().enlarge((String) null)));
        return menu;
    }

    private static JCheckBoxMenuItem toggle(String name, char key, Consumer<Boolean> chosen) {
        JCheckBoxMenuItem item = new QuickToggle(name, true);
        item.setAccelerator(ViewerActions.key(key));
        item.addActionListener(e -> chosen.accept(item.isSelected()));
        return item;
    }

    private void walk(int ahead, int right) {
        Orbit orbit = pane.world().orbit();
        if (orbit != null) {
            double stride = STRIDE * orbit.metresPerPixel(1);
            pane.world().move(orbit.walked(ahead * stride, right * stride));
        }
    }

    private void zoom(double factor) {
        Orbit orbit = pane.world().orbit();
        if (orbit != null) {
            pane.world().move(orbit.zoomed(factor));
        }
    }

    private JMenu window(boolean dark) {
        JMenu menu = new JMenu("Window");
        menu.setMnemonic('W');
        JCheckBoxMenuItem item = new QuickToggle("Dark", dark);
        item.setAccelerator(ViewerActions.menuKey(KeyEvent.VK_D));
        item.addActionListener(e -> darkChosen.accept(item.isSelected()));
        menu.add(item);
        for (int i = 0; i < pane.tabs().getTabCount(); i++) {
            int tab = i;
            menu.add(item(
                    pane.tabs().getTitleAt(i),
                    "Shows this tab",
                    ViewerActions.menuKey(KeyEvent.VK_1 + i),
                    () -> pane.tabs().setSelectedIndex(tab)));
        }
        return menu;
    }

    /** An entry with a tick whose key works at once, as that of {@link QuickItem}. */
    private static final class QuickToggle extends JCheckBoxMenuItem {
        private static final long serialVersionUID = 1L;

        QuickToggle(String name, boolean on) {
            super(name, on);
        }

        @Override
        public void doClick(int pressTime) {
            super.doClick(0);
        }
    }
}
