package org.dronewatch.mesh.io;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assumptions.abort;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.RandomAccessFile;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.dronewatch.setting.InputException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Which files a model is read from: regular ones of bounded size, its libraries from its own directory only. */
class ModelFileTest {
    private static final String BODY = "v 0 0 0\nv 1 0 0\nv 0 1 0\nusemtl brick\nf 1 2 3\n";
    private static final String BRICK = "newmtl brick\nKd 1 0 0\n";

    @TempDir
    private Path root;

    private Path site;

    @BeforeEach
    void makeSite() throws IOException {
        site = Files.createDirectory(root.resolve("site"));
        Files.writeString(root.resolve("secret.mtl"), BRICK);
    }

    private LoadedModel loadWith(String library) throws IOException {
        Files.writeString(site.resolve("model.obj"), "mtllib " + library + "\n" + BODY);
        return new ModelLoader(site).load(ModelSettings.of("model.obj"));
    }

    private void assertRefused(String library, String reason) throws IOException {
        LoadedModel model = loadWith(library);

        assertThat(model.colours()).isEmpty();
        assertThat(model.warnings())
                .singleElement()
                .asString()
                .contains("material library '" + library + "' " + reason)
                .doesNotContain("\n");
    }

    private static void link(Path link, Path target) throws IOException {
        try {
            Files.createSymbolicLink(link, target);
        } catch (UnsupportedOperationException | FileSystemException e) {
            abort("no symbolic links here: " + e.getMessage());
        }
    }

    private static void pipe(Path path) throws IOException, InterruptedException {
        assumeTrue(Files.isExecutable(Path.of("/usr/bin/mkfifo")), "no named pipes here");
        Process process = new ProcessBuilder("/usr/bin/mkfifo", path.toString()).start();
        assertThat(process.waitFor(60, TimeUnit.SECONDS)).isTrue();
        assertThat(process.exitValue()).isZero();
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "../secret.mtl", "sub/../../secret.mtl", "..\\secret.mtl", "sub\\..\\..\\secret.mtl", "/etc/hostname",
                "\\\\server\\share\\x.mtl", "\\x.mtl", "C:\\models\\x.mtl", "c:/x.mtl", "D:x.mtl"
            })
    void aLibraryOutsideTheModelsDirectoryIsRefused(String library) throws IOException {
        assertRefused(library, "leads out of the model's directory");
    }

    @Test
    void anAbsoluteNameIsRefusedEvenInsideTheDirectory() throws IOException {
        Files.writeString(site.resolve("my.mtl"), BRICK);

        assertRefused(site.resolve("my.mtl").toAbsolutePath().toString(), "leads out of the model's directory");
    }

    @Test
    void linksThatLeadOutOfTheDirectoryAreRefused() throws IOException {
        link(site.resolve("linked.mtl"), root.resolve("secret.mtl"));
        link(site.resolve("up"), root);
        link(site.resolve("twice.mtl"), site.resolve("linked.mtl"));

        assertRefused("linked.mtl", "leads out of the model's directory");
        assertRefused("up/secret.mtl", "leads out of the model's directory");
        assertRefused("twice.mtl", "leads out of the model's directory");
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"my.mtl", "sub/my.mtl", "sub\\my.mtl", "./my.mtl", "sub/../my.mtl", "linked.mtl", "my lib.mtl"})
    void aLibraryInsideTheDirectoryIsRead(String library) throws IOException {
        Files.writeString(site.resolve("my.mtl"), BRICK);
        Files.writeString(site.resolve("my lib.mtl"), BRICK);
        Files.createDirectory(site.resolve("sub"));
        Files.writeString(site.resolve("sub/my.mtl"), BRICK);
        link(site.resolve("linked.mtl"), site.resolve("sub/my.mtl"));

        assertThat(loadWith(library).warnings()).isEmpty();
        assertThat(loadWith(library).colours()).containsEntry("brick", 0xff0000);
    }

    @Test
    void theDirectoryItselfMayBeALink() throws IOException {
        Files.writeString(site.resolve("my.mtl"), BRICK);
        Files.writeString(site.resolve("model.obj"), "mtllib my.mtl\n" + BODY);
        link(root.resolve("other"), site);

        assertThat(new ModelLoader(root)
                        .load(ModelSettings.of("other/model.obj"))
                        .warnings())
                .isEmpty();
    }

    @Test
    void aModelThatIsALinkOutOfTheDirectoryOfTheSceneIsRefused() throws IOException {
        Files.writeString(root.resolve("outside.obj"), BODY);
        link(site.resolve("linked.obj"), root.resolve("outside.obj"));
        link(site.resolve("up"), root);

        assertModelRefused("linked.obj", "is a link that leads out of " + site);
        assertModelRefused("up/outside.obj", "is a link that leads out of " + site);
    }

    @Test
    void aModelMayBeALinkWithinTheDirectoryOrANameOfTheUsersOwn() throws IOException {
        Files.createDirectory(site.resolve("sub"));
        Files.writeString(site.resolve("sub/model.obj"), BODY);
        link(site.resolve("linked.obj"), site.resolve("sub/model.obj"));
        link(root.resolve("own.obj"), site.resolve("sub/model.obj"));
        String own = root.resolve("own.obj").toAbsolutePath().toString();

        for (String name : new String[] {"linked.obj", "../own.obj", own}) {
            assertThat(new ModelLoader(site).load(ModelSettings.of(name)).mesh().triangleCount())
                    .isEqualTo(1);
        }
        assertThat(new ModelLoader(Path.of("")).loadAsWritten(own).mesh().triangleCount())
                .isEqualTo(1);
    }

    @Test
    void librariesThatCannotBeReadAreWarningsThatSayWhy() throws IOException {
        Files.createDirectory(site.resolve("folder.mtl"));
        link(site.resolve("broken.mtl"), site.resolve("nowhere.mtl"));
        try (RandomAccessFile large =
                new RandomAccessFile(site.resolve("large.mtl").toFile(), "rw")) {
            large.setLength(ModelFile.MAX_BYTES_BESIDE + 1);
        }

        assertRefused("absent.mtl", "is not next to the model");
        assertRefused("broken.mtl", "is not next to the model");
        assertRefused("folder.mtl", "is a directory");
        assertRefused("large.mtl", "has 16777217 bytes, but may have at most 16777216");
    }

    @Test
    void namedPipesAreNeverOpened() throws IOException, InterruptedException {
        pipe(site.resolve("pipe.mtl"));
        pipe(site.resolve("pipe.obj"));

        assertTimeoutPreemptively(Duration.ofMinutes(1), () -> {
            assertRefused("pipe.mtl", "is a pipe or a device, not a file");
            assertModelRefused("pipe.obj", "is a pipe or a device, not a file");
        });
    }

    @Test
    void devicesAreNeverOpened() throws IOException {
        assumeTrue(Files.exists(Path.of("/dev/zero")), "no devices here");
        link(site.resolve("endless.obj"), Path.of("/dev/zero"));

        assertTimeoutPreemptively(Duration.ofMinutes(1), () -> {
            assertModelRefused("endless.obj", "is a pipe or a device, not a file");
            assertModelRefused("/dev/zero", "is a pipe or a device, not a file");
        });
    }

    @Test
    void aModelBeyondTheLimitIsNotRead() throws IOException {
        try (RandomAccessFile large =
                new RandomAccessFile(site.resolve("large.obj").toFile(), "rw")) {
            large.setLength(ModelFile.MAX_BYTES + 1);
        }

        assertModelRefused("large.obj", "has 1073741825 bytes, but may have at most 1073741824");
    }

    @Test
    void aMissingPackagedModelIsNamed() {
        assertModelRefused("packaged:nosuch.obj", "no packaged model 'nosuch.obj'");
        assertModelRefused("nosuch.obj", "nosuch.obj does not exist");
    }

    private void assertModelRefused(String file, String reason) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new ModelLoader(site).load(ModelSettings.of(file)))
                .withMessageContaining(reason)
                .satisfies(e -> assertThat(e.getMessage()).doesNotContain("\n"));
    }
}
