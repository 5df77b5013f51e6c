package org.dronewatch.viewer;

import java.awt.event.KeyEvent;
import java.util.Optional;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.SwingUtilities;
import javax.swing.event.MenuEvent;
import javax.swing.event.MenuListener;

/**
 * The menu that opens scenes, and writes scenes, pictures and videos.
 *
 * @param saving writes the scene
 * @param opening opens other scenes; empty where the run is fixed
 */
record FileMenu(
        ViewerPane pane,
        Exports exports,
        FilmExport films,
        SceneSaving saving,
        Optional<SceneOpening> opening,
        Runnable closeChosen) {
    JMenu menu() {
        JMenu menu = new JMenu("File");
        menu.setMnemonic('F');
        opening.ifPresent(scenes -> addOpening(menu, scenes));
        menu.add(ViewerMenus.item(
                "Save scene as ...",
                "Writes the settings of the displayed run, with the sensors as you placed them, as a scene file",
                null,
                saving::ask));
        menu.add(ViewerMenus.item(
                "Save site view ...",
                "Writes the 3D view as a PNG image",
                ViewerActions.menuKey(KeyEvent.VK_S),
                () -> exports.savePicture(pane.world(), "site")));
        menu.add(ViewerMenus.item(
                "Save camera views ...",
                "Writes the displayed camera views as a PNG image",
                null,
                () -> exports.savePicture(pane.cameras(), "cameras")));
        menu.add(ViewerMenus.item(
                "Save timeline ...",
                "Writes the timeline as a PNG image",
                null,
                () -> exports.savePicture(pane.timeLine(), "time-line")));
        menu.add(ViewerMenus.item(
                "Save window ...",
                "Writes the whole window as a PNG image",
                ViewerActions.shiftedMenuKey(KeyEvent.VK_S),
                () -> exports.savePicture(pane, "window")));
        menu.add(ViewerMenus.item(
                "Export image sequence ...",
                "Exports the whole run as numbered images of the site",
                ViewerActions.menuKey(KeyEvent.VK_E),
                exports::saveRun));
        menu.add(ViewerMenus.item(
                "Export site video ...",
                "Exports the run as an MP4 video from the current viewpoint",
                ViewerActions.menuKey(KeyEvent.VK_M),
                films::saveSite));
        menu.add(ViewerMenus.item(
                "Export camera video ...",
                "Exports the selected camera's view of the run as an MP4 video",
                ViewerActions.shiftedMenuKey(KeyEvent.VK_M),
                films::saveCamera));
        menu.addSeparator();
        menu.add(ViewerMenus.item("Close", "Closes the window", ViewerActions.menuKey(KeyEvent.VK_W), closeChosen));
        return menu;
    }

    private void addOpening(JMenu menu, SceneOpening scenes) {
        menu.add(ViewerMenus.item(
                "Open ...",
                "Opens another scene file in this window",
                ViewerActions.menuKey(KeyEvent.VK_O),
                () -> scenes.ask(pane)));
        menu.add(ViewerMenus.item(
                "Open packaged scene ...",
                "Shows the packaged scenes to choose from",
                ViewerActions.menuKey(KeyEvent.VK_G),
                () -> scenes.showGallery((JFrame) SwingUtilities.getWindowAncestor(pane))));
        JMenu recent = new JMenu("Open recent");
        scenes.list(recent);
        menu.addMenuListener(new MenuListener() {
            @Override
            public void menuSelected(MenuEvent e) {
                scenes.list(recent);
            }

            @Override
            public void menuDeselected(MenuEvent e) {}

            @Override
            public void menuCanceled(MenuEvent e) {}
        });
        menu.add(recent);
        menu.addSeparator();
    }
}
