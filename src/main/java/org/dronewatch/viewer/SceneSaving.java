package org.dronewatch.viewer;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Locale;
import java.util.function.BiFunction;
import javax.swing.JFileChooser;
import javax.swing.filechooser.FileNameExtensionFilter;
import org.dronewatch.report.file.WholeFile;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.scenario.SceneWriter;

/**
 * Writes the settings of the run that is shown, with its sensors as the user has placed them, as a scene file. All
 * methods are for the event thread.
 */
final class SceneSaving {
    private static final String ENDING = ".yaml";

    private final ViewerPane pane;
    private final String name;
    private final BiFunction<SceneSettings, Path, String> text;

    /**
     * The saving of the scene of a pane.
     *
     * @param name name of the scene, which becomes the name of the file unless the user chooses another
     * @param text returns settings as the text of a file; throws InputException when they cannot be written
     */
    SceneSaving(ViewerPane pane, String name, BiFunction<SceneSettings, Path, String> text) {
        this.pane = pane;
        this.name = name.replaceAll("[^\\w.-]+", "-").replaceFirst("-$", "");
        this.text = text;
    }

    /** Asks for a file and writes the scene. */
    void ask() {
        JFileChooser chooser = new JFileChooser();
        chooser.setDialogTitle("Save the scene of this run");
        chooser.setFileFilter(new FileNameExtensionFilter("Scene files (*.yaml, *.yml)", "yaml", "yml"));
        chooser.setSelectedFile(new java.io.File(name + ENDING));
        if (chooser.showSaveDialog(pane) == JFileChooser.APPROVE_OPTION) {
            String file = chooser.getSelectedFile().getPath();
            boolean hasEnding = file.toLowerCase(Locale.ROOT).matches(".*\\.ya?ml");
            write(hasEnding ? file : file + ENDING);
        }
    }

    /** Writes the scene of the displayed run; errors are shown in the pane. */
    void write(String file) {
        if (pane.viewed().isEmpty()) {
            return;
        }
        try {
            WholeFile target = new WholeFile("scene", file).replacingOnly(SceneWriter.FIRST_LINE, "'save'");
            byte[] bytes = text.apply(pane.placing().settings(), target.path()).getBytes(StandardCharsets.UTF_8);
            target.write(stream -> stream.write(bytes));
            pane.placing().layoutOfSensors().markSaved();
            pane.note("scene written to " + file);
        } catch (RuntimeException e) {
            pane.report(e);
        }
    }
}
