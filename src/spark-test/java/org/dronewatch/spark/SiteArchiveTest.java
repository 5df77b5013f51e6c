package org.dronewatch.spark;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import java.util.zip.ZipEntry;
import java.util.zip.ZipOutputStream;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The archive in which a site reaches executors. */
class SiteArchiveTest {
    @TempDir
    private Path directory;

    private Path site;

    @BeforeEach
    void makeSite() throws IOException {
        site = Files.createDirectories(directory.resolve("site"));
        Files.writeString(site.resolve("site.yaml"), "world: {}");
        Files.createDirectories(site.resolve("models"));
        Files.write(site.resolve("models/house.obj"), new byte[] {1, 0, -1});
    }

    private List<String> unpacked(byte[] archive) throws IOException {
        Path target = Files.createTempDirectory(directory, "unpacked");
        SiteArchive.unpack(archive, target);
        try (Stream<Path> files = Files.walk(target)) {
            return files.filter(Files::isRegularFile)
                    .map(file -> target.relativize(file).toString().replace('\\', '/'))
                    .sorted()
                    .toList();
        }
    }

    @Test
    void whatIsPackedIsUnpackedWithItsBytes() throws IOException {
        Path target = Files.createDirectories(directory.resolve("target"));
        SiteArchive.unpack(SiteArchive.pack(site), target);

        assertThat(target.resolve("site.yaml")).hasContent("world: {}");
        assertThat(target.resolve("models/house.obj")).hasBinaryContent(new byte[] {1, 0, -1});
    }

    @Test
    void hiddenFilesResultsAndLinksThatLeadElsewhereAreLeftOut() throws IOException {
        Files.writeString(site.resolve(".secret"), "x");
        Files.createDirectories(site.resolve(".git"));
        Files.writeString(site.resolve(".git/config"), "x");
        Files.createDirectories(site.resolve("vendors/chunks"));
        Files.writeString(site.resolve("vendors/plan.json"), "{}");
        Path outside = Files.writeString(directory.resolve("outside.obj"), "x");
        Files.createSymbolicLink(site.resolve("out.obj"), outside);
        Files.createSymbolicLink(site.resolve("in.obj"), Path.of("models/house.obj"));

        assertThat(unpacked(SiteArchive.pack(site))).containsExactly("in.obj", "models/house.obj", "site.yaml");
    }

    @Test
    void tooManyFilesAreRefusedWithTheWayOut() throws IOException {
        for (int i = 0; i < SiteArchive.MOST_FILES; i++) {
            Files.createFile(site.resolve("f" + i));
        }
        assertThatThrownBy(() -> SiteArchive.pack(site))
                .isInstanceOf(InputException.class)
                .hasMessageStartingWith(site + ": has more than 10,000 files or 1 GiB")
                .hasMessageContaining("--conf spark.dronewatch.campaign=PATH");
    }

    @Test
    void nothingIsWrittenOutsideTheDirectory() throws IOException {
        for (String name : List.of("../escaped", "a/../../escaped", "/escaped", "", "a/..")) {
            ByteArrayOutputStream bytes = new ByteArrayOutputStream();
            try (ZipOutputStream zip = new ZipOutputStream(bytes)) {
                zip.putNextEntry(new ZipEntry(name));
                zip.write("x".getBytes(StandardCharsets.UTF_8));
            }
            assertThatThrownBy(() -> unpacked(bytes.toByteArray()))
                    .as(name)
                    .isInstanceOf(IOException.class)
                    .hasMessageContaining("would lie outside the directory");
        }
        assertThat(directory.resolve("escaped")).doesNotExist();
        assertThat(Path.of("/escaped")).doesNotExist();
    }
}
