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

    private String stamp(String... entries) throws IOException {
        Path jar = Files.createTempFile(directory, "code", ".jar");
        try (OutputStream file = Files.newOutputStream(jar);
                ZipOutputStream zip = new ZipOutputStream(file)) {
            for (String entry : entries) {
                ZipEntry next = new ZipEntry(entry.substring(0, entry.indexOf(':')));
                next.setTime(0);
                zip.putNextEntry(next);
                zip.write(entry.getBytes(StandardCharsets.UTF_8));
            }
        }
        return CodeStamp.entries(jar);
    }

    @Test
    void theSameCodeInAnotherFileHasTheSameStamp() throws IOException {
        assertThat(stamp("a:1", "b:2")).isEqualTo(stamp("a:1", "b:2"));
    }

    @Test
    void aClassOfTheSameSizeAndTimeWithOtherCodeChangesTheStamp() throws IOException {
        assertThat(stamp("a:1", "b:2")).isNotEqualTo(stamp("a:1", "b:3"));
    }

    @Test
    void anotherClassChangesTheStamp() throws IOException {
        assertThat(stamp("a:1", "b:2")).isNotEqualTo(stamp("a:1", "c:2"));
        assertThat(stamp("a:1")).isNotEqualTo(stamp("a:1", "b:2"));
    }
}
