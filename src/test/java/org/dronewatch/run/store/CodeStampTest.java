package org.dronewatch.run.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Other code is told by the jar that holds it. */
class CodeStampTest {
    @TempDir
    private Path directory;

    private String stamp(String comment, String... entries) throws IOException {
        Path jar = Files.createTempFile(directory, "code", ".jar");
        try (OutputStream file = Files.newOutputStream(jar);
                ZipOutputStream zip = new ZipOutputStream(file)) {
            zip.setComment(comment);
            for (String entry : entries) {
                ZipEntry next = new ZipEntry(entry.substring(0, entry.indexOf(':')));
                next.setTime(0);
                zip.putNextEntry(next);
                zip.write(entry.getBytes(StandardCharsets.UTF_8));
            }
        }
        return CodeStamp.jar(jar);
    }

    @Test
    void theSameCodeInAnotherFileHasTheSameStamp() throws IOException {
        assertThat(stamp(null, "a:1", "b:2")).isEqualTo(stamp(null, "a:1", "b:2"));
        assertThat(stamp("a comment", "a:1", "b:2")).isEqualTo(stamp("a comment", "a:1", "b:2"));
    }

    @Test
    void aClassOfTheSameSizeAndTimeWithOtherCodeChangesTheStamp() throws IOException {
        assertThat(stamp(null, "a:1", "b:2")).isNotEqualTo(stamp(null, "a:1", "b:3"));
        assertThat(stamp("a comment", "a:1", "b:2")).isNotEqualTo(stamp("a comment", "a:1", "b:3"));
    }

    @Test
    void anotherClassChangesTheStamp() throws IOException {
        assertThat(stamp(null, "a:1", "b:2")).isNotEqualTo(stamp(null, "a:1", "c:2"));
        assertThat(stamp(null, "a:1")).isNotEqualTo(stamp(null, "a:1", "b:2"));
    }
}
