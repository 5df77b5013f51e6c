package org.dronewatch.viewer;

import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JFileChooser;
import javax.swing.JFrame;
import javax.swing.JMenu;
import javax.swing.SwingUtilities;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.dronewatch.scene.Scene;
import org.dronewatch.scene.SceneFile;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.PackagedScene;
import org.dronewatch.setting.InputException;
import org.dronewatch.viewer.gallery.ScenePictures;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.part.QuickItem;

/**
 * Opens other scenes, files or packaged ones: reads and checks them on a separate thread, so that a file with mistakes
 * leaves the window as it is.
 */
final class SceneOpening implements AutoCloseable {
    private final RecentScenes recent;
    private final Function<Scene, SceneRunner> runners;
    private final Consumer<Viewer.Subject> chosen;
    private final Consumer<Throwable> failed;
    private final Latest reading;
    private BooleanSupplier mayLeave = () -> true;

    /**
     * An opener of scenes.
     *
     * @param runners returns the runner of a scene
     * @param chosen receives the scene on the reading thread
     * @param failed receives the error in a file
     */
    SceneOpening(
            RecentScenes recent,
            Function<Scene, SceneRunner> runners,
            Consumer<Viewer.Subject> chosen,
            Consumer<Throwable> failed) {
        this.recent = recent;
        this.runners = runners;
        this.chosen = chosen;
        this.failed = failed;
        this.reading = new Latest("dronewatch-opening", 1, failed);
    }

    /** Sets the condition, queried before the user opens another scene, on which the displayed one may be left. */
    void onLeaving(BooleanSupplier decision) {
        mayLeave = decision;
    }

    /** Asks for a file and opens it. */
    void ask(Component parent) {
        if (!mayLeave.getAsBoolean()) {
            return;
        }
        JFileChooser chooser = new JFileChooser(recent.list().stream()
                .findFirst()
                .map(path -> path.getParent().toFile())
                .orElse(null));
        chooser.setDialogTitle("Open a scene");
        chooser.setFileFilter(new FileNameExtensionFilter("Scene files (*.yaml, *.yml)", "yaml", "yml"));
        if (chooser.showOpenDialog(parent) == JFileChooser.APPROVE_OPTION) {
            open(chooser.getSelectedFile().toPath());
        }
    }

    /** Opens a file; a file that no longer exists is removed from the list of recent files. */
    void open(Path file) {
        reading.ask(outdated -> {
            if (!Files.isRegularFile(file)) {
                recent.remove(file);
                failed.accept(new InputException("scene file " + file + ": does not exist"));
                return;
            }
            Viewer.Subject subject = subject(new SceneFile(file), Optional.of(file));
            recent.add(file);
            chosen.accept(subject);
        });
    }

    /** Opens a packaged scene. */
    void open(PackagedScene scene) {
        open(scene.factory().get());
    }

    /** Opens a scene that is not a file. */
    void open(Scene scene) {
        reading.ask(outdated -> chosen.accept(subject(scene, Optional.empty())));
    }

    /** A scene whose settings have been read and checked. */
    private Viewer.Subject subject(Scene scene, Optional<Path> file) {
        SceneRunner runner = runners.apply(scene);
        runner.settings();
        return new Viewer.Subject(scene, runner, file);
    }

    /** Shows the packaged scenes beside the window of the current one. */
    void showGallery(JFrame owner) {
        reading.ask(outdated -> {
            ScenePictures pictures = ScenePictures.read();
            SwingUtilities.invokeLater(() -> GalleryWindow.open(owner, pictures, this));
        });
    }

    /** Whether the scene that is shown may be left; the user may be asked. */
    boolean mayLeave() {
        return mayLeave.getAsBoolean();
    }

    /** Fills a menu with the files opened last. */
    void list(JMenu menu) {
        menu.removeAll();
        for (Path file : recent.list()) {
            menu.add(new QuickItem(
                    ViewerActions.action(String.valueOf(file.getFileName()), file.toString(), null, () -> {
                        if (mayLeave.getAsBoolean()) {
                            open(file);
                        }
                    })));
        }
        menu.setEnabled(menu.getItemCount() > 0);
    }

    /** Ends the thread that reads. */
    @Override
    public void close() {
        reading.close();
    }
}
