package org.dronewatch.jmh;

import java.awt.Frame;
import java.awt.Point;
import java.awt.Robot;
import java.awt.event.InputEvent;
import java.awt.event.KeyEvent;
import java.util.Arrays;
import java.util.concurrent.ConcurrentLinkedQueue;
import javax.swing.SwingUtilities;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.MultiSensor;
import org.dronewatch.viewer.Viewer;

/**
 * The time for which the viewer's event thread keeps an event waiting. By real mouse and keys, it opens the scene of
 * the house, plays it, turns and zooms the site, steps, jumps, enlarges cameras and changes tabs; meanwhile, an event
 * is posted every 5 ms. It needs a separate display, such as a virtual one.
 */
public final class EventThreadDelay {
    private static final int EVERY = 5;

    private final ConcurrentLinkedQueue<Double> delays = new ConcurrentLinkedQueue<>();
    private final Robot robot;
    private volatile boolean watching = true;

    private EventThreadDelay() throws java.awt.AWTException {
        robot = new Robot();
        robot.setAutoDelay(8);
    }

    /** Measures and prints. */
    public static void main(String[] arguments) throws Exception {
        new EventThreadDelay().run();
    }

    private void run() throws Exception {
        SceneRunner runner = new SceneRunner(new MultiSensor());
        try (Viewer viewer =
                Viewer.open(new MultiSensor(), runner, Runtime.getRuntime().availableProcessors())) {
            Thread watch = new Thread(this::watch);
            watch.start();
            runner.listener(viewer.listener()).run();
            viewer.finished(true);
            Thread.sleep(4000);
            print("loading and first pictures");
            use();
            print("played, turned, zoomed, clicked");
            watching = false;
            watch.join();
        }
    }

    private void watch() {
        try {
            while (watching) {
                long posted = System.nanoTime();
                SwingUtilities.invokeLater(() -> delays.add(1e-6 * (System.nanoTime() - posted)));
                Thread.sleep(EVERY);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
    }

    private void use() {
        Point corner = Frame.getFrames()[0].getLocationOnScreen();
        int width = Frame.getFrames()[0].getWidth();
        int height = Frame.getFrames()[0].getHeight();
        for (int round = 0; round < 4; round++) {
            int x = corner.x + width / 3;
            int y = corner.y + height / 2;
            robot.mouseMove(x, y);
            robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
            for (int i = 0; i < 60; i++) {
                robot.mouseMove(x + 3 * i, y + i);
            }
            robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
            for (int i = 0; i < 12; i++) {
                robot.mouseWheel(i < 6 ? -1 : 1);
                robot.delay(30);
            }
            key(KeyEvent.VK_PERIOD);
            key(KeyEvent.VK_HOME);
            key(KeyEvent.VK_SPACE);
            robot.mouseMove(corner.x + width * 4 / 5, corner.y + height / 5);
            click();
            robot.delay(1500);
            click();
            robot.mouseMove(corner.x + width / 2, corner.y + height - 70);
            click();
            robot.delay(1500);
            key(KeyEvent.VK_2);
            robot.delay(500);
            key(KeyEvent.VK_R);
            robot.delay(2000);
            key(KeyEvent.VK_1);
        }
    }

    private void click() {
        robot.mousePress(InputEvent.BUTTON1_DOWN_MASK);
        robot.mouseRelease(InputEvent.BUTTON1_DOWN_MASK);
    }

    private void key(int code) {
        robot.keyPress(code);
        robot.keyRelease(code);
    }

    private void print(String what) {
        double[] sorted = delays.stream().mapToDouble(Double::doubleValue).toArray();
        delays.clear();
        Arrays.sort(sorted);
        long above = Arrays.stream(sorted).filter(delay -> delay > 50.0).count();
        System.out.printf(
                "%s: %d events, median %.2f ms, 99 %% %.1f ms, longest %.1f ms, %d above 50 ms%n",
                what,
                sorted.length,
                sorted[sorted.length / 2],
                sorted[sorted.length * 99 / 100],
                sorted[sorted.length - 1],
                above);
    }
}
