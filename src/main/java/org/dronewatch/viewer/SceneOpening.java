package org.dronewatch.viewer;

import java.awt.Component;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import javax.swing.JFileChooser;
import javax.swing.JMenu;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.dronewatch.setting.InputException;
import org.dronewatch.viewer.part.Latest;
import org.dronewatch.viewer.part.QuickItem;

/** Opens other scene files: reads and checks them on a thread, so that one with mistakes leaves the window as it is. */
final class SceneOpening implements AutoCloseable {
    private final RecentScenes recent;
    private final Function<Path, Viewer.Subject> reader;
    private final Consumer<Viewer.Subject> chosen;
    private final Consumer<Throwable> failed;
    private final Latest reading;
    private BooleanSupplier mayLeave = () -> true;

    /**
     * An opening.
     *
     * @param reader reads and checks a file; throws InputException
     * @param chosen receives the scene on the reading thread
     * @param failed receives the error in a file
     */
    SceneOpening(
            RecentScenes recent,
            Function<Path, Viewer.Subject> reader,
            Consumer<Viewer.Subject> chosen,
            Consumer<Throwable> failed) {
        this.recent = recent;
        this.reader = reader;
        this.chosen = chosen;
        this.failed = failed;
        this.reading = new Latest("dronewatch-opening", 1, failed);
    }

    /** Decides, before a file is opened by the user, whether the scene that is shown may be left. */
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

    /** Opens a file; one that is gone is no longer offered. */
    void open(Path file) {
        reading.ask(outdated -> {
            if (!Files.isRegularFile(file)) {
                recent.remove(file);
                failed.accept(new InputException("scene file " + file + ": does not exist"));
                return;
            }
            Viewer.Subject subject = reader.apply(file);
            recent.add(file);
            chosen.accept(subject);
        });
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
