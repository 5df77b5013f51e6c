package org.dronewatch.viewer;

import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.dronewatch.viewer.ShownWindow.find;
import static org.dronewatch.viewer.ShownWindow.frame;
import static org.dronewatch.viewer.ShownWindow.pane;

import java.awt.Component;
import java.awt.Point;
import java.awt.Rectangle;
import java.awt.Robot;
import java.awt.event.MouseEvent;
import java.awt.image.BufferedImage;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import javax.imageio.ImageIO;
import javax.swing.JComponent;
import javax.swing.JMenu;
import javax.swing.JMenuItem;
import javax.swing.JTable;
import org.dronewatch.app.Main;
import org.dronewatch.geometry.Position;
import org.dronewatch.viewer.part.Scaled;
import org.jogamp.vecmath.Point2d;

/**
 * Opens a window by the command {@code view}, uses it, prints what it shows, opens the scene that was opened last
 * before, and closes it. For a process of its own, whose class path may have more kinds than that of the tests.
 */
public final class UsedWindow {
    private UsedWindow() {}

    /**
     * Uses a window.
     *
     * @param arguments where to keep pictures of the window, at which time of the run, the sensor to click on, and the
     *     command
     */
    public static void main(String[] arguments) throws Exception {
        String pictures = arguments[0];
        double time = Double.parseDouble(arguments[1]);
        int[] code = {-1};
        Thread command = new Thread(() -> code[0] = Main.execute(
                new PrintWriter(System.err, true),
                new PrintWriter(System.err, true),
                Arrays.copyOfRange(arguments, 3, arguments.length)));
        command.start();
        await("the window", () -> frame().isPresent());
        ViewerPane first = settled(null, time);
        print(first, "", arguments[2], time);
        keep(pictures);
        onEventThread(() -> {
            first.rayPanel().trace();
            return null;
        });
        await("the window", first::isIdle);
        onEventThread(() -> null);
        System.out.println("rays: " + onEventThread(() -> first.rayPanel().count()));

        onEventThread(() -> {
            openLast();
            return null;
        });
        ViewerPane second = settled(first, time);
        System.out.println("other: " + frame().orElseThrow().getTitle());
        print(second, "other ", "camera", time);
        keep(pictures + "-swapped");

        ShownWindow.close();
        command.join();
        System.out.println("exit " + code[0]);
    }

    /** The pane that has taken the place of another, once its run is over and all of a time is drawn. */
    private static ViewerPane settled(ViewerPane other, double time) throws Exception {
        await("the window", () -> pane().filter(pane -> pane != other
                        && pane.viewed().isPresent()
                        && pane.recording().isFinished())
                .isPresent());
        ViewerPane pane = pane().orElseThrow();
        onEventThread(() -> {
            pane.playback().pause();
            pane.playback().jump(time);
            return null;
        });
        await("the window", () -> pane.playback().time() == time && pane.isIdle());
        // Tables follow a little later.
        Thread.sleep(500);
        await("the window", pane::isIdle);
        return pane;
    }

    private static void print(ViewerPane pane, String prefix, String sensor, double time) throws Exception {
        onEventThread(() -> {
            JTable table = find(pane, JTable.class).orElseThrow();
            tellCutNames(table, prefix);
            for (int row = 0; row < table.getRowCount(); row++) {
                int fixed = row;
                System.out.println(prefix + "row "
                        + IntStream.range(0, table.getColumnCount())
                                .mapToObj(column -> String.valueOf(table.getValueAt(fixed, column)))
                                .collect(Collectors.joining(" | ")));
            }
            if (pane.notice().isVisible()) {
                System.out.println("notice " + pane.notice().text());
            }
            tellTimeLine(pane, sensor);
            return null;
        });
        Point at = onEventThread(() -> symbol(pane, sensor));
        BufferedImage image = onEventThread(() -> pane.world().image());
        double density = pane.world().density();
        int colour = image.getRGB((int) (at.x * density), (int) (at.y * density)) & 0xffffff;
        System.out.printf("symbol of %s: #%06x%n", sensor, colour);
        onEventThread(() -> {
            click(pane.world(), at.x, at.y);
            return null;
        });
        System.out.println(
                prefix + "clicked: " + onEventThread(() -> pane.selected().orElse("nothing")));
        await("the window", pane::isIdle);
    }

    /** Kinds for which their column is too narrow have the whole name in their tool tip. */
    private static void tellCutNames(JTable table, String prefix) {
        table.getColumnModel().getColumn(1).setWidth(Scaled.px(30));
        for (int row = 0; row < table.getRowCount(); row++) {
            JComponent cell = (JComponent) table.prepareRenderer(table.getCellRenderer(row, 1), row, 1);
            System.out.println(prefix + "cut: " + cell.getToolTipText());
        }
        table.doLayout();
    }

    /** What the pointer says where the sensor begins to detect a drone. */
    private static void tellTimeLine(ViewerPane pane, String sensor) {
        TimeLine line = pane.timeLine();
        int row = pane.viewed().orElseThrow().settings().sensors().keySet().stream()
                .toList()
                .indexOf(sensor);
        int y = (int) (line.yOf(row) + 0.5 * line.rowHeight());
        for (int x = line.left(); x < line.getWidth(); x++) {
            String text = line.getToolTipText(
                    new MouseEvent(line, MouseEvent.MOUSE_MOVED, 0L, 0, x, y, 0, false, MouseEvent.NOBUTTON));
            if (text.contains(" detects ")) {
                System.out.println("time line of " + sensor + ": " + text);
                return;
            }
        }
    }

    private static Point symbol(ViewerPane pane, String sensor) {
        WorldPanel world = pane.world();
        Position position =
                pane.viewed().orElseThrow().settings().sensors().get(sensor).position();
        Point2d at = world.orbit()
                .camera(world.getWidth(), world.getHeight())
                .pixelOf(position.toPoint3d())
                .orElseThrow();
        return new Point((int) Math.round(at.x), (int) Math.round(at.y));
    }

    private static void click(Component part, int x, int y) {
        int[] events = {MouseEvent.MOUSE_PRESSED, MouseEvent.MOUSE_RELEASED, MouseEvent.MOUSE_CLICKED};
        for (int event : events) {
            int held = event == MouseEvent.MOUSE_PRESSED ? MouseEvent.BUTTON1_DOWN_MASK : 0;
            part.dispatchEvent(
                    new MouseEvent(part, event, System.currentTimeMillis(), held, x, y, 1, false, MouseEvent.BUTTON1));
        }
    }

    /** File, Open recent, and there what was opened last before the scene that is shown. */
    private static void openLast() {
        JMenu file = frame().orElseThrow().getJMenuBar().getMenu(0);
        JMenu recent = Stream.of(file.getMenuComponents())
                .filter(JMenu.class::isInstance)
                .map(JMenu.class::cast)
                .filter(menu -> menu.getText().equals("Open recent"))
                .findFirst()
                .orElseThrow();
        ((JMenuItem) recent.getMenuComponent(1)).doClick();
    }

    private static void keep(String name) throws Exception {
        Rectangle bounds = onEventThread(() -> frame().orElseThrow().getBounds());
        ImageIO.write(
                new Robot().createScreenCapture(bounds),
                "png",
                Path.of(name + ".png").toFile());
    }
}
