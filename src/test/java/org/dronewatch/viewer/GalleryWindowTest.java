package org.dronewatch.viewer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dronewatch.viewer.EventThread.await;
import static org.dronewatch.viewer.EventThread.onEventThread;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.awt.Component;
import java.awt.Toolkit;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import javax.swing.JButton;
import javax.swing.JFrame;
import javax.swing.text.BadLocationException;
import org.dronewatch.render.Yard;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.viewer.gallery.SceneGallery;
import org.dronewatch.viewer.part.WrappedText;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The gallery of packaged scenes, on a display: by mouse and by keys, at the start and beside a scene. */
class GalleryWindowTest {
    private static final double LONGEST = 0.05;

    @TempDir
    private Path directory;

    private CompletableFuture<Optional<Viewer.Subject>> choice;

    @BeforeEach
    void needDisplay() {
        assumeTrue(
                Viewer.obstacle().isEmpty(),
                () -> "no window: " + Viewer.obstacle().orElse(""));
    }

    @AfterEach
    void closeAll() throws Exception {
        onEventThread(() -> {
            showing().forEach(window -> window.dispatchEvent(new WindowEvent(window, WindowEvent.WINDOW_CLOSING)));
            return null;
        });
    }

    private static SceneRunner runner(Scene scene) {
        return new SceneRunner(scene).threads(1);
    }

    private static List<Window> showing() {
        return Stream.of(Window.getWindows()).filter(Window::isShowing).toList();
    }

    private static Optional<SceneGallery> gallery() {
        return showing().stream()
                .filter(javax.swing.RootPaneContainer.class::isInstance)
                .map(window -> ((javax.swing.RootPaneContainer) window).getContentPane())
                .filter(SceneGallery.class::isInstance)
                .map(SceneGallery.class::cast)
                .findFirst();
    }

    private SceneGallery begin() throws Exception {
        choice = CompletableFuture.supplyAsync(
                () -> GalleryWindow.choose(GalleryWindowTest::runner, directory.resolve("viewer.properties")));
        await("the gallery", () -> gallery().isPresent());
        return gallery().orElseThrow();
    }

    /** The height of wrapped text if all of it is shown, in pixels. */
    private static double wholeHeight(WrappedText text) {
        try {
            return text.modelToView2D(text.getDocument().getLength()).getMaxY();
        } catch (BadLocationException e) {
            throw new AssertionError(e);
        }
    }

    private static void press(Component part, int code) throws Exception {
        onEventThread(() -> {
            for (int id : new int[] {KeyEvent.KEY_PRESSED, KeyEvent.KEY_RELEASED}) {
                part.dispatchEvent(
                        new KeyEvent(part, id, System.currentTimeMillis(), 0, code, KeyEvent.CHAR_UNDEFINED));
            }
            return null;
        });
    }

    @Test
    void everyPackagedSceneHasACardWithPictureNameAndSentence() throws Exception {
        SceneGallery gallery = begin();
        List<JButton> buttons = gallery.buttons();

        assertThat(buttons.stream().map(JButton::getText))
                .containsExactlyElementsOf(
                        PackagedScene.all().stream().map(PackagedScene::name).toList());
        assertThat(buttons).allSatisfy(button -> {
            assertThat(button.getIcon().getIconWidth()).isGreaterThan(250);
            assertThat(button.getAccessibleContext().getAccessibleName()).isEqualTo(button.getText());
            assertThat(button.getAccessibleContext().getAccessibleDescription()).matches("[A-Z].*[a-z]\\.");
        });
        assertThat(Parts.in(gallery)
                        .filter(WrappedText.class::isInstance)
                        .map(WrappedText.class::cast)
                        .filter(text -> text.getText().endsWith(".")))
                .hasSameSizeAs(buttons)
                .allSatisfy(text -> assertThat(wholeHeight(text))
                        .as("all lines of: %s", text.getText())
                        .isLessThanOrEqualTo(text.getHeight()));
        KeptPicture.of(showing().get(0), "gallery");
    }

    @Test
    void keysMoveBetweenCardsAndOpenOneWithoutHoldingUpTheEventThread() throws Exception {
        BusyTimes times = new BusyTimes();
        SceneGallery gallery = begin();
        List<JButton> buttons = gallery.buttons();
        onEventThread(() -> null);
        Toolkit.getDefaultToolkit().getSystemEventQueue().push(times);
        try {
            press(buttons.get(0), KeyEvent.VK_RIGHT);
            press(buttons.get(1), KeyEvent.VK_DOWN);
            press(buttons.get(3), KeyEvent.VK_ENTER);
            Optional<Viewer.Subject> chosen = choice.get(20, TimeUnit.SECONDS);

            assertThat(chosen.orElseThrow().scene().name()).isEqualTo("multi-sensor");
            assertThat(chosen.orElseThrow().file()).isEmpty();
            await("the gallery is gone", () -> gallery().isEmpty());
        } finally {
            times.end();
        }
        assertThat(times.longest()).as("processor time of the longest event, s").isLessThan(LONGEST);
    }

    @Test
    void theChosenSceneRunsAsWithoutTheGallery() throws Exception {
        SceneGallery gallery = begin();
        onEventThread(() -> {
            gallery.buttons().get(0).doClick(0);
            return null;
        });
        SceneRunner chosen = choice.get(20, TimeUnit.SECONDS).orElseThrow().runner();
        PackagedScene first = PackagedScene.all().get(0);

        assertThat(chosen.settings()).isEqualTo(new SceneRunner(first.factory().get()).settings());
    }

    @Test
    void escapeAndTheCloseButtonEndWithoutAScene() throws Exception {
        SceneGallery gallery = begin();
        press(gallery.buttons().get(0), KeyEvent.VK_ESCAPE);
        assertThat(choice.get(20, TimeUnit.SECONDS)).isEmpty();
        await("the gallery is gone", () -> gallery().isEmpty());

        begin();
        closeAll();
        assertThat(choice.get(20, TimeUnit.SECONDS)).isEmpty();
    }

    @Test
    void theMenuShowsItBesideAScene() throws Exception {
        Yard yard = new Yard(directory);
        Viewer.Subject first = new Viewer.Subject(yard, new SceneRunner(yard), Optional.empty());
        CompletableFuture<Optional<Viewer.Subject>> next = new CompletableFuture<>();
        CompletableFuture<Viewer> opened = new CompletableFuture<>();
        Thread watching = new Thread(() -> {
            Viewer viewer = Viewer.open(
                    first, 1, directory.resolve("viewer.properties"), Optional.of(GalleryWindowTest::runner));
            viewer.finished(true);
            opened.complete(viewer);
            next.complete(viewer.awaitNext());
        });
        watching.start();
        Viewer viewer = opened.get(20, TimeUnit.SECONDS);
        JFrame frame = viewer.window().frame();
        onEventThread(() -> {
            viewer.opening().orElseThrow().showGallery(frame);
            return null;
        });
        await("the gallery", () -> gallery().isPresent());
        onEventThread(() -> {
            gallery().orElseThrow().buttons().get(0).doClick(0);
            return null;
        });

        assertThat(next.get(20, TimeUnit.SECONDS).orElseThrow().scene().name()).isEqualTo("closed-space");
        await("the new title", () -> frame.getTitle().startsWith("closed-space"));
        assertThat(gallery()).isEmpty();
        viewer.close();
        watching.join(TimeUnit.SECONDS.toMillis(20));
    }
}
