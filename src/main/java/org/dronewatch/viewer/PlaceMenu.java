package org.dronewatch.viewer;

import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import javax.swing.JMenu;
import javax.swing.KeyStroke;

/** The menu for moving and turning the selected sensor with keys. */
final class PlaceMenu {
    /** The distance by which a key moves a sensor, m; with Shift, ten times as much. */
    private static final double STEP = 1.0;

    private static final double FAR = 10.0 * STEP;

    /** The angle by which a key turns a sensor, rad. */
    private static final double TURN = Math.toRadians(5.0);

    private PlaceMenu() {}

    static JMenu of(PlacingPanel placing) {
        JMenu menu = new JMenu("Place");
        menu.setMnemonic('P');
        SensorMover mover = placing.mover();
        add(menu, "Move north", "Moves the selected sensor 1 m north", KeyEvent.VK_UP, () -> mover.shift(0, STEP));
        add(menu, "Move south", "Moves the selected sensor 1 m south", KeyEvent.VK_DOWN, () -> mover.shift(0, -STEP));
        add(menu, "Move west", "Moves the selected sensor 1 m west", KeyEvent.VK_LEFT, () -> mover.shift(-STEP, 0));
        add(menu, "Move east", "Moves the selected sensor 1 m east", KeyEvent.VK_RIGHT, () -> mover.shift(STEP, 0));
        addFar(
                menu,
                "Move 10 m north",
                "Moves the selected sensor 10 m north",
                KeyEvent.VK_UP,
                () -> mover.shift(0, FAR));
        addFar(
                menu,
                "Move 10 m south",
                "Moves the selected sensor 10 m south",
                KeyEvent.VK_DOWN,
                () -> mover.shift(0, -FAR));
        addFar(
                menu,
                "Move 10 m west",
                "Moves the selected sensor 10 m west",
                KeyEvent.VK_LEFT,
                () -> mover.shift(-FAR, 0));
        addFar(
                menu,
                "Move 10 m east",
                "Moves the selected sensor 10 m east",
                KeyEvent.VK_RIGHT,
                () -> mover.shift(FAR, 0));
        menu.addSeparator();
        add(menu, "Raise", "Raises the selected sensor by 1 m", KeyEvent.VK_PAGE_UP, () -> mover.raise(STEP));
        add(menu, "Lower", "Lowers the selected sensor by 1 m", KeyEvent.VK_PAGE_DOWN, () -> mover.raise(-STEP));
        menu.addSeparator();
        add(menu, "Turn left", "Turns the selected sensor 5 degrees to the left", 'Q', () -> mover.turn(-TURN, 0));
        add(menu, "Turn right", "Turns the selected sensor 5 degrees to the right", 'E', () -> mover.turn(TURN, 0));
        add(menu, "Tilt up", "Tilts the selected sensor up by 5 degrees", 'T', () -> mover.turn(0, TURN));
        add(menu, "Tilt down", "Tilts the selected sensor down by 5 degrees", 'G', () -> mover.turn(0, -TURN));
        menu.addSeparator();
        menu.add(ViewerMenus.item(
                "Undo", "Undoes the last change to a sensor", ViewerActions.menuKey(KeyEvent.VK_Z), placing::undo));
        menu.add(ViewerMenus.item(
                "Redo",
                "Redoes the last change that was undone",
                ViewerActions.shiftedMenuKey(KeyEvent.VK_Z),
                placing::redo));
        return menu;
    }

    private static void add(JMenu menu, String name, String explanation, int key, Runnable work) {
        menu.add(ViewerMenus.item(name, explanation, KeyStroke.getKeyStroke(key, InputEvent.ALT_DOWN_MASK), work));
    }

    private static void addFar(JMenu menu, String name, String explanation, int key, Runnable work) {
        menu.add(ViewerMenus.item(
                name,
                explanation,
                KeyStroke.getKeyStroke(key, InputEvent.ALT_DOWN_MASK | InputEvent.SHIFT_DOWN_MASK),
                work));
    }
}
