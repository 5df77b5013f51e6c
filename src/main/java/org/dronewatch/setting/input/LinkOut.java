package org.dronewatch.setting.input;

import java.io.IOException;
import java.nio.file.Path;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;

/**
 * Rejects symbolic links that lead out of a scene's directory, so that a scene file from another author cannot read
 * other files. File names relative to the working directory and file names that visibly lead elsewhere are accepted:
 * scene files that contain such names are refused, so it was the user who chose these names.
 */
public final class LinkOut {
    private LinkOut() {}

    /**
     * Rejects a file that is reached by such a link.
     *
     * @param directory the directory of the scene file; empty for the working directory
     * @param file an existing file
     * @param what first words of the message, such as {@code model file}
     * @throws InputException when the file lies outside the directory, or cannot be read
     */
    public static void refuse(Path directory, Path file, String what) {
        if (directory.toString().isEmpty() || !file.normalize().startsWith(directory.normalize())) {
            return;
        }
        try {
            if (!file.toRealPath().startsWith(directory.toRealPath())) {
                throw new InputException(what + " " + PlainText.value(file) + " is a link that leads out of "
                        + PlainText.value(directory) + ": keep the file itself in it or below it");
            }
        } catch (IOException e) {
            throw new InputException(
                    what + " " + PlainText.value(file) + " cannot be read: " + BoundedFile.reason(e), e);
        }
    }
}
