package org.dronewatch.viewer;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.function.Consumer;
import javax.swing.JCheckBoxMenuItem;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.KeyStroke;
import org.dronewatch.render.Orbit;
import org.dronewatch.viewer.part.QuickItem;
import org.dronewatch.viewer.part.QuickToggle;

/** The menus, each entry with its key. */
final class ViewerMenus {
    /** The fraction of the distance to the target by which one key press moves the viewpoint. */
    private static final double STRIDE = 0.06;

    private final ViewerPane pane;
    private final FileMenu file;
    private final Consumer<Boolean> darkChosen;
    private final Runnable keysChosen;

    /**
     * The menus of a pane.
     *
     * @param file the menu that opens and writes
     * @param darkChosen receives whether the dark theme is chosen
     * @param keysChosen opens the page of keys
     */
    ViewerMenus(ViewerPane pane, FileMenu file, Consumer<Boolean> darkChosen, Runnable keysChosen) {
        this.pane = pane;
        this.file = file;
        this.darkChosen = darkChosen;
        this.keysChosen = keysChosen;
    }

    JMenuBar bar(boolean dark) {
        JMenuBar bar = new JMenuBar();
        bar.add(file.menu());
        bar.add(run());
        bar.add(view());
        bar.add(PlaceMenu.of(pane.placing()));
        bar.add(window(dark));
        bar.add(help());
        return bar;
    }

    static JMenuItem item(String name, String explanation, KeyStroke key, Runnable work) {
        return new QuickItem(ViewerActions.action(name, explanation, key, work));
    }

    private JMenu help() {
        JMenu menu = new JMenu("Help");
        menu.setMnemonic('H');
        menu.add(item(
                "Keys and mouse", "Lists all keys and mouse gestures", ViewerActions.key(KeyEvent.VK_F1), keysChosen));
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
                "Trace sound rays",
                "Traces all sound rays to the selected microphone at the displayed time",
                ViewerActions.key(KeyEvent.VK_R),
                pane.rayPanel()::trace));
        menu.add(item(
                "Show other run beside this one",
                "Shows or hides the run with which this one is compared, at the same time and from the same viewpoint",
                ViewerActions.key(KeyEvent.VK_B),
                pane.comparing()::toggle));
        menu.add(item(
                "Compute coverage",
                "Computes where the sensors detect a drone, and shows it over the site",
                ViewerActions.shiftedMenuKey(KeyEvent.VK_K),
                pane::showCoverage));
        return menu;
    }

    private JMenu view() {
        JMenu menu = new JMenu("View");
        menu.setMnemonic('V');
        pane.views().forEach(view -> menu.add(new QuickItem(view)));
        menu.addSeparator();
        WorldPanel world = pane.world();
        menu.add(toggle(
                "Names",
                "Shows or hides names",
                'N',
                shown -> world.setStyle(world.style().withLabels(shown))));
        menu.add(toggle(
                "Fields of view",
                "Shows or hides fields of view",
                'O',
                shown -> world.setStyle(world.style().withOutlines(shown))));
        menu.add(toggle(
                "Flights",
                "Shows or hides the drones' flights",
                'L',
                shown -> world.setStyle(world.style().withFlights(shown))));
        menu.add(item(
                "Coverage",
                "Shows or hides the coverage that was computed",
                ViewerActions.key(KeyEvent.VK_K),
                () -> pane.coverage().toggle()));
        menu.addSeparator();
        menu.add(item(
                "Move forward",
                "Moves the viewpoint forward at constant height",
                ViewerActions.key(KeyEvent.VK_W),
                () -> walk(1, 0)));
        menu.add(item(
                "Move back",
                "Moves the viewpoint back at constant height",
                ViewerActions.key(KeyEvent.VK_S),
                () -> walk(-1, 0)));
        menu.add(item(
                "Move left",
                "Moves the viewpoint left at constant height",
                ViewerActions.key(KeyEvent.VK_A),
                () -> walk(0, -1)));
        menu.add(item(
                "Move right",
                "Moves the viewpoint right at constant height",
                ViewerActions.key(KeyEvent.VK_D),
                () -> walk(0, 1)));
        menu.add(
                item("Zoom in", "Moves the viewpoint closer", ViewerActions.key(KeyEvent.VK_PAGE_UP), () -> zoom(0.8)));
        menu.add(item(
                "Zoom out",
                "Moves the viewpoint farther" + " away",
                ViewerActions.key(KeyEvent.VK_PAGE_DOWN),
                () -> zoom(1.25)));
        menu.addSeparator();
        menu.add(item(
                "Measure",
                "Measures between two points that you click on: distance, height, bearing and line of sight",
                ViewerActions.key(KeyEvent.VK_M),
                pane.measuring()::toggle));
        menu.add(item(
                "Measure from or to selection",
                "Sets one end of the measured line at the selected sensor or drone",
                KeyStroke.getKeyStroke(KeyEvent.VK_M, InputEvent.SHIFT_DOWN_MASK),
                () -> pane.measuring().put(pane.selected())));
        menu.addSeparator();
        menu.add(toggle(
                "Cameras in colour",
                "Switches between colour pictures from the cameras and distances in shades of blue",
                'C',
                false,
                shown -> pane.cameras().showColour(shown)));
        menu.add(item(
                "All cameras",
                "Ends measuring; if nothing is being measured, shows all cameras side by side",
                ViewerActions.key(KeyEvent.VK_ESCAPE),
                () -> {
                    if (!pane.measuring().end()) {
                        pane.cameras().enlarge((String) null);
                    }
                }));
        return menu;
    }

    private static JCheckBoxMenuItem toggle(String name, String explanation, char key, Consumer<Boolean> chosen) {
        return toggle(name, explanation, key, true, chosen);
    }

    private static JCheckBoxMenuItem toggle(
            String name, String explanation, char key, boolean at, Consumer<Boolean> chosen) {
        JCheckBoxMenuItem item = new QuickToggle(name, at);
        item.setToolTipText(explanation);
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
        item.setToolTipText("Switches between the dark and the light theme");
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
}
