package org.dronewatch.setting.input;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import org.dronewatch.setting.RegularFile;

/** Reads small files named by the user. Pipes and devices are refused: reading them may block or never end. */
public final class BoundedFile {
    private BoundedFile() {}

    /**
     * All bytes of a file.
     *
     * @param most maximum number of bytes; no more are read
     * @throws InputException when there is no such file, or it is a directory, a pipe, a device or too large
     */
    public static byte[] read(Path file, int most) {
        String obstacle = RegularFile.obstacle(file);
        if (!obstacle.isEmpty()) {
            throw new InputException(PlainText.value(file) + ": cannot be read: " + obstacle);
        }
        try (InputStream in = Files.newInputStream(file)) {
            byte[] bytes = in.readNBytes(most + 1);
            if (bytes.length > most) {
                throw new InputException(
                        PlainText.value(file) + ": larger than " + most + " bytes, the limit for such a file");
            }
            return bytes;
        } catch (IOException e) {
            throw new InputException(PlainText.value(file) + ": cannot be read: " + reason(e), e);
        }
    }

    /** Why a file cannot be read, without its name. */
    static String reason(IOException problem) {
        if (problem instanceof NoSuchFileException) {
            return "no such file";
        }
        String known = problem instanceof FileSystemException refused ? refused.getReason() : problem.getMessage();
        return known == null ? "no permission" : known;
    }
}
