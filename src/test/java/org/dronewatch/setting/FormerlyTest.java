package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.Node;
import org.dronewatch.setting.file.SettingsFile;
import org.junit.jupiter.api.Test;

/** Former names of settings, in files and paths, of records that are there for this test. */
class FormerlyTest {
    sealed interface Lens {
        record Prime(@Formerly("focus") double focalLength) implements Lens {}

        record Zoom(@Formerly({"near", "wide"}) double shortest, double longest) implements Lens {}
    }

    record Camera(@Formerly("columns") int width, Optional<Lens> lens, @Formerly("fellow") Optional<Camera> other) {
        @Defaults
        static final Camera DEFAULT = new Camera(640, Optional.empty(), Optional.empty());

        Camera withLens(Lens other) {
            return new Camera(width, Optional.of(other), other());
        }
    }

    record Ambiguous(@Formerly("height") int width, int height) {}

    record AmbiguousBefore(@Formerly("size") int width, @Formerly("size") int height) {}

    private final FormerNames used = new FormerNames();

    private static Node.Mapping document(String file, String text) throws Exception {
        return SettingsFile.document(file, new ByteArrayInputStream(text.getBytes(StandardCharsets.UTF_8)));
    }

    private Camera read(Node.Mapping document) {
        return SettingsFile.read(document, Camera.class, Kinds.FOUND, Path.of(""), used);
    }

    private Camera read(String text) throws Exception {
        return read(document("a.yaml", text));
    }

    private static Camera camera(int width) {
        return new Camera(width, Optional.empty(), Optional.empty());
    }

    @Test
    void aFileMayUseAFormerName() throws Exception {
        assertThat(read("columns: 800\n")).isEqualTo(camera(800));
        assertThat(used.warnings().values()).containsExactly("a.yaml:1:1: setting 'columns' is now called 'width'");
    }

    @Test
    void thePresentNameGivesNoWarning() throws Exception {
        assertThat(read("width: 800\n")).isEqualTo(camera(800));
        assertThat(used.warnings()).isEmpty();
    }

    @Test
    void thereIsOneWarningForEachNameWithTheNumberOfPlaces() throws Exception {
        read("columns: 800\nfellow:\n  columns: 900\n  fellow: {columns: 1000}\n");
        assertThat(used.warnings().values())
                .containsExactly(
                        "a.yaml:1:1: setting 'columns' is now called 'width'"
                                + " (the former name is also used in 2 other places)",
                        "a.yaml:2:1: setting 'fellow' is now called 'other'"
                                + " (the former name is also used in 1 other place)");
    }

    @Test
    void aKindIsKnownByTheFormerNamesOfItsSettings() throws Exception {
        assertThat(read("lens: {focus: 50}\n")).isEqualTo(camera(640).withLens(new Lens.Prime(50)));
        assertThat(read("lens: {wide: 20, longest: 80}\n"))
                .isEqualTo(camera(640).withLens(new Lens.Zoom(20, 80)));
    }

    @Test
    void bothNamesTogetherAreAMistakeInOneLineWithBothPlaces() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> read("other:\n  width: 800\n  columns: 800\n"))
                .withMessage("a.yaml:3:3: other: 'columns' is a former name of 'width';"
                        + " it is already given at a.yaml:2:3");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> read("columns: 800\nwidth: 800\n"))
                .withMessage(
                        "a.yaml:2:1: 'width' is also written under a former name; it is already given at a.yaml:1:1");
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> read("lens: {near: 20, wide: 20, longest: 80}\n"))
                .withMessageContaining("'wide' is a former name of 'shortest'; it is already given at a.yaml:1:8");
    }

    @Test
    void anOverlayReplacesWhatIsBelowItByWhicheverName() throws Exception {
        Node.Mapping former = document("below.yaml", "columns: 800\nfellow: {lens: {focus: 50}, columns: 700}\n");
        Node.Mapping present = document("above.yaml", "width: 900\nother: {width: 1000}\n");
        Camera other = camera(1000).withLens(new Lens.Prime(50));
        assertThat(read(former.overlaidWith(present))).isEqualTo(new Camera(900, Optional.empty(), Optional.of(other)));

        Camera turned = camera(700).withLens(new Lens.Prime(50));
        assertThat(read(present.overlaidWith(former)))
                .isEqualTo(new Camera(800, Optional.empty(), Optional.of(turned)));
    }

    @Test
    void aPathMayUseFormerNames() {
        Camera inner = camera(640).withLens(new Lens.Prime(50));
        Camera tree = new Camera(640, Optional.empty(), Optional.of(inner));
        assertThat(new SettingsPath("fellow.lens.focus").<Camera>write(tree, "35"))
                .isEqualTo(new SettingsPath("other.lens.focalLength").<Camera>write(tree, "35"));
        assertThat(new SettingsPath("fellow.columns").read(tree)).isEqualTo(640);
        assertThat(new CurrentPath(tree, used).of("fellow.lens.focus", "--set")).isEqualTo("other.lens.focalLength");
        assertThat(used.warnings().values())
                .containsExactly(
                        "--set: setting 'fellow' is now called 'other'",
                        "--set: setting 'focus' is now called 'focalLength'");
    }

    @Test
    void aPathThatLeadsNowhereIsLeftAsItIs() {
        for (String path : List.of("", "fellow.columns", "no.columns", "lens.0", "width.columns", "..")) {
            String expected = path.replace("fellow", "other");
            assertThat(new CurrentPath(camera(1), new FormerNames()).of(path, "--set"))
                    .isEqualTo(expected);
        }
    }

    @Test
    void suggestionsArePresentNames() {
        assertThatExceptionOfType(InputException.class)
                .isThrownBy(() -> read("column: 800\n"))
                .withMessageContaining("unknown setting 'column'")
                .withMessageContaining("(width, lens, other)")
                .withMessageNotContaining("columns");
    }

    @Test
    void aFormerNameMeansOneComponent() {
        for (Class<?> record : Set.of(Ambiguous.class, AmbiguousBefore.class)) {
            assertThatIllegalStateException()
                    .isThrownBy(() -> SettingsForm.of(record))
                    .withMessageContaining("is a name of another component");
        }
    }
}
