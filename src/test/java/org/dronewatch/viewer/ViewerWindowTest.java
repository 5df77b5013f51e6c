package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Component;
import java.awt.Container;
import java.awt.event.KeyEvent;
import java.awt.event.MouseEvent;
import java.awt.event.MouseWheelEvent;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.JMenuBar;
import javax.swing.JMenuItem;
import javax.swing.SwingUtilities;
import org.dronewatch.render.Orbit;
import org.dronewatch.render.Yard;
import org.dronewatch.run.SceneResult;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.sensor.camera.CameraSettings;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The real window, on a display: opened, played, stepped, clicked, closed. Its pictures are kept in target/viewer. */
class ViewerWindowTest {

    @TempDir
    private Path directory;

    private Viewer viewer;

    @BeforeEach
    void needDisplay() {
        assumeTrue(
                Viewer.obstacle().isEmpty(),
                () -> "no window: " + Viewer.obstacle().orElse(""));
    }

    private static void press(Component part, int id, int x, int y, int button, int modifiers, int clicks) {
        part.dispatchEvent(
                new MouseEvent(part, id, System.currentTimeMillis(), modifiers, x, y, clicks, false, button));
    }

    private static void click(Component part, int x, int y) throws Exception {
        onEventThread(() -> {
            press(part, MouseEvent.MOUSE_PRESSED, x, y, MouseEvent.BUTTON1, MouseEvent.BUTTON1_DOWN_MASK, 1);
            press(part, MouseEvent.MOUSE_RELEASED, x, y, MouseEvent.BUTTON1, 0, 1);
            press(part, MouseEvent.MOUSE_CLICKED, x, y, MouseEvent.BUTTON1, 0, 1);
            return null;
        });
    }

    private void key(int code) throws Exception {
        onEventThread(() -> {
            Component part = viewer.pane().world();
            for (int id : new int[] {KeyEvent.KEY_PRESSED, KeyEvent.KEY_RELEASED}) {
                part.dispatchEvent(new KeyEvent(
                        part,
                        id,
                        System.currentTimeMillis(),
                        0,
                        code,
                        KeyEvent.getKeyText(code).charAt(0)));
            }
            return null;
        });
    }

    private static List<String> ownThreads() {
        return Thread.getAllStackTraces().keySet().stream()
                .filter(Thread::isAlive)
                .map(Thread::getName)
                .filter(name -> name.startsWith("dronewatch"))
                .collect(Collectors.toList());
    }

    @Test
    void opensPlaysStepsClicksAndCloses() throws Exception {
        SceneResult alone = new SceneRunner(new Yard(directory)).run();
        Path layout = directory.resolve("viewer.properties");
        Yard yard = new Yard(directory);
        SceneRunner runner = new SceneRunner(yard);
        viewer = Viewer.open(yard, runner, 2, layout);
        ViewerPane pane = viewer.pane();
        SceneResult result =
                runner.listener(viewer.listener()).cancelWhen(viewer::isClosed).run();
        viewer.finished(true);

        assertThat(result.runs()).as("the results without a viewer").isEqualTo(alone.runs());

        // It plays by itself once its site is there, and time goes on.
        await(
                "the site is there",
                () -> pane.viewed().isPresent() && pane.world().image() != null);
        await(
                "time goes on",
                () -> pane.playback().isPlaying() && pane.playback().time() > 0.3);
        key(KeyEvent.VK_SPACE);
        assertThat(onEventThread(() -> pane.playback().isPlaying())).isFalse();

        double before = onEventThread(() -> pane.playback().time());
        key(KeyEvent.VK_PERIOD);
        assertThat(onEventThread(() -> pane.playback().time())).isGreaterThan(before);
        key(KeyEvent.VK_COMMA);
        key(KeyEvent.VK_COMMA);
        assertThat(onEventThread(() -> pane.playback().time())).isLessThan(before);

        // A click on the time line jumps.
        TimeLine line = pane.timeLine();
        click(line, (int) Math.round(onEventThread(() -> line.xOf(8.0))), 5);
        assertThat(onEventThread(() -> pane.playback().time())).isBetween(7.95, 8.05);
        await("all is drawn", pane::isIdle);
        KeptPicture.of(viewer.window().frame(), "window");

        // Dragging turns the site, the wheel zooms.
        WorldPanel world = pane.world();
        Orbit first = onEventThread(world::orbit);
        onEventThread(() -> {
            press(world, MouseEvent.MOUSE_PRESSED, 200, 200, MouseEvent.BUTTON1, MouseEvent.BUTTON1_DOWN_MASK, 1);
            press(world, MouseEvent.MOUSE_DRAGGED, 260, 220, 0, MouseEvent.BUTTON1_DOWN_MASK, 0);
            press(world, MouseEvent.MOUSE_RELEASED, 260, 220, MouseEvent.BUTTON1, 0, 1);
            world.dispatchEvent(new MouseWheelEvent(
                    world,
                    MouseEvent.MOUSE_WHEEL,
                    System.currentTimeMillis(),
                    0,
                    260,
                    220,
                    0,
                    false,
                    MouseWheelEvent.WHEEL_UNIT_SCROLL,
                    3,
                    -2));
            return null;
        });
        Orbit turned = onEventThread(world::orbit);
        assertThat(turned.bearing()).isNotEqualTo(first.bearing());
        assertThat(turned.elevation()).isGreaterThan(first.elevation());
        assertThat(turned.distance()).isLessThan(first.distance());

        // A click on a camera enlarges and selects it.
        CameraVisual visual = onEventThread(() -> pane.cameras().shown().get(0));
        click(visual, visual.getWidth() / 2, visual.getHeight() / 2);
        assertThat(pane.selected()).contains("camera");

        // Rays, dark.
        key(KeyEvent.VK_R);
        await("rays", () -> pane.rays().isPresent());
        onEventThread(() -> {
            item(viewer.window().frame().getJMenuBar(), "Dark").doClick();
            return null;
        });
        await("all is drawn", pane::isIdle);
        Thread.sleep(200);
        KeptPicture.of(viewer.window().frame(), "window-dark");

        viewer.close();
        assertThat(viewer.isClosed()).isTrue();
        assertNoThreadsLeft();
        assertThat(JFrame.getFrames()).noneMatch(java.awt.Frame::isDisplayable);
        assertThat(Files.readString(layout)).contains("theme=dark").contains("divider.across=");
    }

    private static JMenuItem item(JMenuBar bar, String text) {
        return Stream.of(bar.getComponents())
                .map(javax.swing.JMenu.class::cast)
                .flatMap(menu -> Stream.of(menu.getMenuComponents()))
                .filter(JMenuItem.class::isInstance)
                .map(JMenuItem.class::cast)
                .filter(entry -> entry.getText().equals(text))
                .findFirst()
                .orElseThrow();
    }

    @Test
    void everyEntryOfTheMenusHasAnExplanationAndEveryKeyIsGivenOnce() throws Exception {
        Yard yard = new Yard(directory);
        viewer = Viewer.open(yard, new SceneRunner(yard), 1, directory.resolve("viewer.properties"));
        try {
            JMenuBar bar = viewer.window().frame().getJMenuBar();
            List<JMenuItem> items = Stream.of(bar.getComponents())
                    .map(javax.swing.JMenu.class::cast)
                    .flatMap(menu -> Stream.of(menu.getMenuComponents()))
                    .filter(JMenuItem.class::isInstance)
                    .map(JMenuItem.class::cast)
                    .toList();
            assertThat(items).hasSizeGreaterThan(25);
            assertThat(items.stream().map(JMenuItem::getAccelerator).filter(java.util.Objects::nonNull))
                    .hasSizeGreaterThan(20)
                    .doesNotHaveDuplicates();
            assertThat(buttons(viewer.pane()))
                    .allSatisfy(button -> assertThat(button.getToolTipText() + button.getText())
                            .isNotBlank());
        } finally {
            viewer.close();
        }
    }

    @Test
    void thePageOfKeysHoldsEveryKeyOfTheMenusAndTheMouse() throws Exception {
        Yard yard = new Yard(directory);
        viewer = Viewer.open(yard, new SceneRunner(yard), 1, directory.resolve("viewer.properties"));
        try {
            JMenuBar bar = viewer.window().frame().getJMenuBar();
            String page = onEventThread(() -> KeysPage.html(bar));
            List<JMenuItem> keyed = Stream.of(bar.getComponents())
                    .map(javax.swing.JMenu.class::cast)
                    .flatMap(menu -> Stream.of(menu.getMenuComponents()))
                    .filter(JMenuItem.class::isInstance)
                    .map(JMenuItem.class::cast)
                    .filter(entry -> entry.getAccelerator() != null)
                    .toList();
            assertThat(KeysPage.entries(bar)).hasSameSizeAs(keyed);
            assertThat(keyed).allSatisfy(entry -> assertThat(page)
                    .contains("<td>" + KeysPage.text(entry.getAccelerator()) + "</td><td>" + entry.getText()));
            assertThat(page).contains("Right-drag").contains("Wheel").contains("<td>F1</td><td>Keys and mouse</td>");
            onEventThread(() -> {
                item(bar, "Keys and mouse").doClick();
                return null;
            });
            Thread.sleep(400);
            KeptPicture.of(viewer.window().frame(), "keys");
        } finally {
            viewer.close();
        }
        await("its window and the page are gone", () -> Stream.of(java.awt.Window.getWindows())
                .noneMatch(java.awt.Window::isDisplayable));
    }

    @Test
    void anotherSceneTakesThePlaceOfTheFirstAndBadOnesLeaveItAsItIs() throws Exception {
        Path scene = directory.resolve("second.yaml");
        Files.writeString(
                scene, Files.readString(Path.of("scenes/hill-radar.yaml")).replaceAll("duration: .*", "duration: 2 s"));
        Path bad = directory.resolve("bad.yaml");
        Files.writeString(bad, "world: {models: [packaged:hill.obj], nose: 3}\n");
        Path gone = directory.resolve("gone.yaml");
        RecentScenes recent = new RecentScenes(directory.resolve("recent-scenes.txt"));
        recent.add(gone);
        Yard yard = new Yard(directory);
        Viewer.Subject first = new Viewer.Subject(yard, new SceneRunner(yard), Optional.empty());
        Thread watching = new Thread(
                () -> {
                    viewer = Viewer.open(
                            first, 1, directory.resolve("viewer.properties"), Optional.of(ViewerWindowTest::runner));
                    Optional<Viewer.Subject> shown = Optional.of(first);
                    while (shown.isPresent()) {
                        try {
                            viewer.finished(shown.get()
                                    .runner()
                                    .listener(viewer.listener())
                                    .cancelWhen(viewer::isLeft)
                                    .run()
                                    .complete());
                        } catch (java.util.concurrent.CancellationException e) {
                            assertThat(viewer.isLeft()).isTrue();
                        }
                        shown = viewer.awaitNext();
                    }
                },
                "watching");
        watching.start();
        while (viewer == null || viewer.window() == null) {
            Thread.sleep(10);
        }
        try {
            await("the first is there", () -> viewer.pane().viewed().isPresent());
            ViewerPane yardPane = viewer.pane();
            SceneOpening opening = new SceneOpening(recent, ViewerWindowTest::runner, subject -> {}, yardPane::report);
            opening.open(bad);
            await("the mistake is told", () -> yardPane.notice().isVisible());
            assertThat(yardPane.notice().text()).contains("bad.yaml:1:").contains("nose");
            opening.open(gone);
            await("the gap is told", () -> yardPane.notice().text().contains("gone.yaml: does not exist"));
            opening.close();
            assertThat(recent.list()).as("what is gone is not offered again").isEmpty();
            assertThat(viewer.pane()).isSameAs(yardPane);

            onEventThread(() -> {
                viewer.opening().orElseThrow().open(scene);
                return null;
            });
            await(
                    "the second is there",
                    () -> viewer.pane() != yardPane
                            && viewer.pane().viewed().isPresent()
                            && viewer.pane().world().image() != null);
            assertThat(viewer.window().frame().getTitle()).isEqualTo("second - dronewatch");
            assertThat(recent.list()).containsExactly(scene.toAbsolutePath());
            assertThat(viewer.pane().viewed().orElseThrow().settings().sensors())
                    .containsOnlyKeys("radar");
            // Those of one pane: site, picture, cameras, stage, rays, and the one that opens.
            assertThat(ownThreads().stream().filter(name -> !name.contains("worker")))
                    .doesNotHaveDuplicates();
            KeptPicture.of(viewer.window().frame(), "opened");
        } finally {
            viewer.close();
        }
        watching.join(TimeUnit.SECONDS.toMillis(20));
        assertThat(watching.isAlive()).isFalse();
        assertNoThreadsLeft();
    }

    private static void assertNoThreadsLeft() throws InterruptedException {
        long end = System.nanoTime() + TimeUnit.SECONDS.toNanos(10);
        while (!ownThreads().isEmpty() && System.nanoTime() < end) {
            Thread.sleep(20);
        }
        assertThat(ownThreads()).as("threads left behind").isEmpty();
    }

    private static SceneRunner runner(Scene scene) {
        return new SceneRunner(scene).threads(1);
    }

    private static List<JButton> buttons(Container container) {
        return Stream.of(container.getComponents())
                .flatMap(part -> Stream.concat(
                        part instanceof JButton button ? Stream.of(button) : Stream.of(),
                        part instanceof Container inside ? buttons(inside).stream() : Stream.of()))
                .toList();
    }

    @Test
    void aWindowThatIsClosedWhileModelsAreReadEndsTheReading() throws Exception {
        StringBuilder model = new StringBuilder("v 0 0 0\nv 1 0 0\nv 0 1 0\n");
        for (int i = 0; i < 3_000_000; i++) {
            model.append("f 1 2 3\n");
        }
        Yard yard = new Yard(directory);
        Files.writeString(directory.resolve("yard.obj"), model);
        SceneRunner runner = new SceneRunner(yard);
        Thread[] running = new Thread[1];
        Throwable[] outcome = new Throwable[1];
        running[0] = new Thread(() -> {
            viewer = Viewer.open(yard, runner, 2, directory.resolve("viewer.properties"));
            try {
                runner.listener(viewer.listener()).cancelWhen(viewer::isClosed).run();
            } catch (RuntimeException e) {
                outcome[0] = e;
            }
        });
        running[0].start();
        while (viewer == null || viewer.window() == null) {
            Thread.sleep(10);
        }
        Thread.sleep(200);
        viewer.close();
        running[0].join(TimeUnit.SECONDS.toMillis(20));

        assertThat(running[0].isAlive()).isFalse();
        assertThat(outcome[0]).isInstanceOf(java.util.concurrent.CancellationException.class);
    }

    @Test
    void aCameraOfAnotherProgramHasAWindowOfItsOwn() throws Exception {
        Yard yard = new Yard(directory);
        CameraSettings settings = (CameraSettings) yard.settings().sensors().get("camera");
        DepthImageFrame frame = onEventThread(() -> new DepthImageFrame("gate"));
        frame.show(settings.create(), yard.stage().world(), yard.stage().dronesAt(8.0));
        SwingUtilities.invokeAndWait(() -> {});

        assertThat(frame.isShowing()).isTrue();
        assertThat(frame.getTitle()).isEqualTo("gate");
        assertThat(frame.getContentPane().getWidth()).isEqualTo(settings.width());
        onEventThread(() -> {
            frame.dispose();
            return null;
        });
    }
}
