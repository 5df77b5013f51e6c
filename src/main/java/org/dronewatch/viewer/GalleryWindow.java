package org.dronewatch.viewer;

import java.awt.Dimension;
import java.awt.GraphicsEnvironment;
import java.awt.Rectangle;
import java.awt.Window;
import java.awt.event.KeyEvent;
import java.awt.event.WindowAdapter;
import java.awt.event.WindowEvent;
import java.nio.file.Path;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.ExecutionException;
import java.util.function.Function;
import javax.swing.JComponent;
import javax.swing.JDialog;
import javax.swing.JFrame;
import javax.swing.JRootPane;
import javax.swing.SwingUtilities;
import javax.swing.WindowConstants;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.viewer.gallery.SceneGallery;
import org.dronewatch.viewer.gallery.ScenePictures;
import org.dronewatch.viewer.part.EventWork;
import org.dronewatch.viewer.part.Texts;

/** A window in which the user chooses a packaged scene or a scene file. */
public final class GalleryWindow {
    private static final String TITLE = "Choose a scene - dronewatch";

    private GalleryWindow() {}

    /**
     * Lets the user choose the scene that is shown first, and returns when one is chosen or the window is closed. Not
     * for the event thread. A scene file with mistakes is reported in the window, which stays open.
     *
     * @param runners returns the runner of a scene
     * @return the scene with its runner; empty if the user closes the window
     * @throws IllegalStateException when there is no display
     */
    public static Optional<Viewer.Subject> choose(Function<Scene, SceneRunner> runners) {
        return choose(runners, ViewerLayout.ofUser());
    }

    static Optional<Viewer.Subject> choose(Function<Scene, SceneRunner> runners, Path layoutFile) {
        Optional<String> obstacle = Viewer.obstacle();
        if (obstacle.isPresent()) {
            throw new IllegalStateException(obstacle.get());
        }
        CompletableFuture<Optional<Viewer.Subject>> choice = new CompletableFuture<>();
        SceneGallery[] gallery = new SceneGallery[1];
        RecentScenes recent = new RecentScenes(layoutFile.resolveSibling("recent-scenes.txt"));
        ViewerLayout layout = new ViewerLayout(layoutFile);
        ScenePictures pictures = ScenePictures.read();
        JFrame[] frame = new JFrame[1];
        try (SceneOpening opening = new SceneOpening(
                recent,
                runners,
                subject -> choice.complete(Optional.of(subject)),
                problem -> SwingUtilities.invokeLater(() -> gallery[0].report(Texts.problem(problem))))) {
            EventWork.await(() -> {
                ViewerWindow.setLook(layout.isDark());
                frame[0] = new JFrame(TITLE);
                gallery[0] = new SceneGallery(pictures, opening::open, () -> opening.ask(frame[0]));
                frame[0].setDefaultCloseOperation(WindowConstants.DO_NOTHING_ON_CLOSE);
                frame[0].addWindowListener(new WindowAdapter() {
                    @Override
                    public void windowClosing(WindowEvent e) {
                        choice.complete(Optional.empty());
                    }
                });
                frame[0].setContentPane(gallery[0]);
                onEscape(frame[0].getRootPane(), () -> choice.complete(Optional.empty()));
            });
            EventWork.await(() -> show(frame[0], gallery[0]));
            return choice.get();
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            return Optional.empty();
        } catch (ExecutionException e) {
            throw new IllegalStateException(e.getCause());
        } finally {
            SwingUtilities.invokeLater(frame[0]::dispose);
        }
    }

    /** Shows the gallery beside the window of a scene, which the chosen one replaces. */
    static void open(JFrame owner, ScenePictures pictures, SceneOpening opening) {
        JDialog dialog = new JDialog(owner, TITLE, false);
        dialog.setDefaultCloseOperation(WindowConstants.DISPOSE_ON_CLOSE);
        SceneGallery gallery = new SceneGallery(
                pictures,
                scene -> {
                    if (opening.mayLeave()) {
                        dialog.dispose();
                        opening.open(scene);
                    }
                },
                () -> {
                    dialog.dispose();
                    opening.ask(owner);
                });
        dialog.setContentPane(gallery);
        onEscape(dialog.getRootPane(), dialog::dispose);
        show(dialog, gallery);
    }

    private static void onEscape(JRootPane root, Runnable work) {
        root.registerKeyboardAction(
                e -> work.run(), ViewerActions.key(KeyEvent.VK_ESCAPE), JComponent.WHEN_IN_FOCUSED_WINDOW);
    }

    private static void show(Window window, SceneGallery gallery) {
        window.pack();
        Rectangle screen = GraphicsEnvironment.getLocalGraphicsEnvironment().getMaximumWindowBounds();
        Dimension size = window.getSize();
        // If there is no room for all rows of cards, they scroll.
        window.setSize(Math.min(size.width, screen.width), Math.min(size.height, screen.height));
        window.setLocationRelativeTo(window.getOwner());
        window.setVisible(true);
        gallery.begin();
    }
}
