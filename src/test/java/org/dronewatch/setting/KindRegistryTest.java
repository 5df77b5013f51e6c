package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.jar.JarEntry;
import java.util.jar.JarOutputStream;
import org.dronewatch.flight.FlightPathSettings;
import org.dronewatch.sensor.SensorSettings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class KindRegistryTest {
    /** Something of which there may be several kinds. */
    interface Lamp {}

    sealed interface Closed permits Candle {}

    record Bulb(double watts) implements Lamp {}

    record Candle(double length) implements Lamp, Closed {}

    private static FoundKind found(String name, Class<? extends Lamp> settings, String source, boolean builtIn) {
        return new FoundKind(Kind.of(Lamp.class, name, settings, "gives light"), source, builtIn);
    }

    @Test
    void thoseOfTheLibraryComeFirstThenTheOthersByNameWhateverTheOrderOfTheJars() {
        FoundKind own = found("zenith", Bulb.class, "own.jar", true);
        FoundKind a = found("arc", Bulb.class, "b.jar", false);
        FoundKind b = found("candle", Candle.class, "a.jar", false);
        for (List<FoundKind> order : List.of(List.of(a, b, own), List.of(b, own, a))) {
            KindRegistry registry = new KindRegistry(order);
            assertThat(registry.of(Lamp.class).keySet()).containsExactly("zenith", "arc", "candle");
            assertThat(registry.all()).containsExactly(own, a, b);
        }
    }

    @Test
    void aNameThatIsThereTwiceIsRefusedInOneLineWithBothPlaces() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new KindRegistry(List.of(
                        found("arc", Bulb.class, "/lib/one.jar", false),
                        found("arc", Candle.class, "/lib/two.jar", false))))
                .withMessage(
                        "kind 'arc' of Lamp is in /lib/one.jar and in /lib/two.jar: remove one of them from the class path");
    }

    @Test
    void theSameNameMayBeThatOfAKindOfSomethingElse() {
        interface Rope {}
        record Cotton(double length) implements Rope {}
        KindRegistry registry = new KindRegistry(List.of(
                found("plain", Bulb.class, "a", false),
                new FoundKind(Kind.of(Rope.class, "plain", Cotton.class, "a rope"), "b", false)));
        assertThat(registry.of(Lamp.class)).containsEntry("plain", Bulb.class);
        assertThat(registry.of(Rope.class)).containsEntry("plain", Cotton.class);
    }

    @ParameterizedTest
    @ValueSource(strings = {"", "Arc", "a b", "a.b", "../a", "-a"})
    void aNameThatCannotBeWrittenInAPathIsRefused(String name) {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> found(name, Bulb.class, "a.jar", false))
                .withMessageContaining("a.jar: its name must be");
    }

    @Test
    void whatCannotBeChosenIsRefused() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new FoundKind(Kind.of(Closed.class, "c", Candle.class, "x"), "a.jar", false))
                .withMessageContaining("must be a non-sealed interface");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> found("lamp", Lamp.class, "a.jar", false))
                .withMessageContaining("must be a record that implements Lamp");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> new FoundKind(Kind.of(Lamp.class, "c", Bulb.class, "two\nlines"), "a.jar", false))
                .withMessageContaining("one line");
    }

    @Test
    void theLibrarysOwnAreFoundOnTheClassPath() {
        assertThat(KindRegistry.found().of(SensorSettings.class).keySet())
                .containsExactly("camera", "acoustic", "radar", "rf", "thermal");
        assertThat(Choices.of(FlightPathSettings.class))
                .hasSize(15)
                .containsKeys("hover", "pop-up", "steered", "mission", "track");
        assertThat(KindRegistry.found().all()).allMatch(FoundKind::builtIn);
        assertThat(KindRegistry.found().all())
                .allSatisfy(one -> assertThat(Choices.nameOf(one.kind().settings()))
                        .isEqualTo(one.kind().name()));
    }

    /** A provider of another jar whose code fails. */
    public static final class Broken implements KindGroup {
        @Override
        public List<Kind<?>> kinds() {
            throw new IllegalStateException("no licence\nfound");
        }
    }

    @Test
    void aProviderThatFailsIsOneLine(@TempDir Path directory) throws IOException {
        Path services = Files.createDirectories(directory.resolve("META-INF/services"));
        Files.writeString(services.resolve(KindGroup.class.getName()), Broken.class.getName() + "\n");
        try (URLClassLoader loader = new URLClassLoader(
                new URL[] {directory.toUri().toURL()}, getClass().getClassLoader())) {
            assertThatExceptionOfType(InputException.class)
                    .isThrownBy(() -> KindRegistry.load(loader))
                    .withMessageContaining("provider " + Broken.class.getName() + " from ")
                    .withMessageContaining("no licence")
                    .withMessageNotContaining("\n");
        }
    }

    /** A provider of which there are an old and a new jar. */
    public static final class Twice implements KindGroup {
        @Override
        public List<Kind<?>> kinds() {
            return List.of();
        }
    }

    private static Path jarOf(Path jar, String provider) throws IOException {
        try (JarOutputStream entries = new JarOutputStream(Files.newOutputStream(jar))) {
            entries.putNextEntry(new JarEntry("META-INF/services/" + KindGroup.class.getName()));
            entries.write(("# kinds of another project\n" + provider + " # one\n").getBytes(StandardCharsets.UTF_8));
        }
        return jar;
    }

    @Test
    void anOldAndANewCopyOfAJarAreRefusedInOneLineWithBothPlaces(@TempDir Path directory) throws IOException {
        // The rule leaves out classes of the library itself, to which those of this test belong.
        String provider = "org.example.Twice";
        Path older = jarOf(directory.resolve("older.jar"), provider).toRealPath();
        Path newer = jarOf(directory.resolve("newer.jar"), provider).toRealPath();
        URL[] both = {older.toUri().toURL(), newer.toUri().toURL()};
        try (URLClassLoader loader = new URLClassLoader(both, getClass().getClassLoader())) {
            assertThatExceptionOfType(InputException.class)
                    .isThrownBy(() -> KindRegistry.load(loader))
                    .withMessage("class path: provider org.example.Twice is in " + older + " and in " + newer
                            + ": remove one of them from the class path");
        }
    }

    @Test
    void theLibraryItselfMayBeThereTwice(@TempDir Path directory) throws IOException {
        URL[] both = {
            jarOf(directory.resolve("all.jar"), Twice.class.getName()).toUri().toURL(),
            jarOf(directory.resolve("thin.jar"), Twice.class.getName()).toUri().toURL()
        };
        try (URLClassLoader loader = new URLClassLoader(both, getClass().getClassLoader())) {
            assertThat(KindRegistry.load(loader)).allMatch(FoundKind::builtIn);
        }
    }

    @Test
    void aProviderThatIsNotThereIsOneLine(@TempDir Path directory) throws IOException {
        Path services = Files.createDirectories(directory.resolve("META-INF/services"));
        Files.writeString(services.resolve(Kind.class.getName()), "org.example.Gone\n");
        try (URLClassLoader loader =
                new URLClassLoader(new URL[] {directory.toUri().toURL()})) {
            assertThatExceptionOfType(InputException.class)
                    .isThrownBy(() -> KindRegistry.load(loader))
                    .withMessageContaining("org.example.Gone")
                    .withMessageNotContaining("\n");
        }
    }
}
