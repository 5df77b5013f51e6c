package org.dronewatch.viewer;

import java.awt.Component;
import java.awt.event.KeyEvent;
import java.util.ArrayList;
import java.util.List;
import javax.swing.JDialog;
import javax.swing.JEditorPane;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.JScrollPane;
import javax.swing.KeyStroke;
import org.dronewatch.viewer.part.Scaled;

/** A page of all keys, taken from the menus, and of the mouse gestures. */
final class KeysPage {
    /** Mouse gestures and their effects. */
    private static final String[][] GESTURES = {
        {"Drag", "rotates the site"},
        {"Right-drag or Shift-drag", "moves the site"},
        {"Control-drag", "looks around from the same point"},
        {"Wheel", "zooms towards the pointer"},
        {"Click", "selects a sensor or drone"},
        {"Drag the selected sensor", "moves it over ground and roofs"},
        {"Double-click", "centres on a point and zooms in"},
        {"Click while measuring", "sets one end of the measured line at a point, a sensor or a drone"},
        {"Click on a camera", "enlarges it; another click shows all cameras"},
        {"Click or drag on the timeline", "jumps to a time"},
    };

    /** One key with what it does. */
    record Entry(String menu, String name, String key, String explanation) {}

    private KeysPage() {}

    /** All menu entries that have a key, in the order of the menus. */
    static List<Entry> entries(JMenuBar bar) {
        List<Entry> entries = new ArrayList<>();
        for (int i = 0; i < bar.getMenuCount(); i++) {
            collect(bar.getMenu(i).getText(), bar.getMenu(i), entries);
        }
        return entries;
    }

    private static void collect(String name, JMenu menu, List<Entry> entries) {
        for (Component part : menu.getMenuComponents()) {
            if (part instanceof JMenu inner) {
                collect(name, inner, entries);
            } else if (part instanceof JMenuItem item && item.getAccelerator() != null) {
                String explanation = item.getToolTipText();
                entries.add(new Entry(
                        name, item.getText(), text(item.getAccelerator()), explanation == null ? "" : explanation));
            }
        }
    }

    /** A key in words, such as {@code Ctrl+S}. */
    static String text(KeyStroke key) {
        String modifiers = KeyEvent.getModifiersExText(key.getModifiers());
        String own = KeyEvent.getKeyText(key.getKeyCode());
        return modifiers.isEmpty() ? own : modifiers + "+" + own;
    }

    /** The page as HTML. */
    static String html(JMenuBar bar) {
        StringBuilder page = new StringBuilder("<html><body><h2>Keys</h2><table cellpadding=2>");
        String menu = "";
        for (Entry entry : entries(bar)) {
            if (!entry.menu().equals(menu)) {
                menu = entry.menu();
                page.append("<tr><td colspan=3><b>").append(escaped(menu)).append("</b></td></tr>");
            }
            row(page, entry.key(), entry.name(), entry.explanation());
        }
        page.append("</table><h2>Mouse</h2><table cellpadding=2>");
        for (String[] gesture : GESTURES) {
            row(page, gesture);
        }
        return page.append("</table></body></html>").toString();
    }

    private static void row(StringBuilder page, String... cells) {
        page.append("<tr>");
        for (String cell : cells) {
            page.append("<td>").append(escaped(cell)).append("</td>");
        }
        page.append("</tr>");
    }

    private static String escaped(String text) {
        return text.replace("&", "&amp;").replace("<", "&lt;");
    }

    /** Opens the page beside a window. */
    static JDialog open(JFrame owner) {
        JEditorPane text = new JEditorPane("text/html", html(owner.getJMenuBar()));
        text.putClientProperty(JEditorPane.HONOR_DISPLAY_PROPERTIES, Boolean.TRUE);
        text.setFont(Scaled.font(1.0));
        text.setEditable(false);
        text.setCaretPosition(0);
        text.getAccessibleContext().setAccessibleName("keys");
        JDialog dialog = new JDialog(owner, "Keys and mouse - dronewatch", false);
        dialog.setDefaultCloseOperation(JDialog.DISPOSE_ON_CLOSE);
        dialog.getRootPane()
                .registerKeyboardAction(
                        e -> dialog.dispose(),
                        ViewerActions.key(KeyEvent.VK_ESCAPE),
                        javax.swing.JComponent.WHEN_IN_FOCUSED_WINDOW);
        dialog.setContentPane(new JScrollPane(text));
        dialog.setSize(Scaled.size(620, 680));
        dialog.setLocationRelativeTo(owner);
        dialog.setVisible(true);
        return dialog;
    }
}
