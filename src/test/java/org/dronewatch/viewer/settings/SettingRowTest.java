package org.dronewatch.viewer.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.scene.SceneRunner;
import org.dronewatch.scenes.MultiSensor;
import org.dronewatch.sensor.SensorSettings;
import org.dronewatch.setting.SettingsPath;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** What is shown of a setting can be typed as it is, and then changes nothing. */
class SettingRowTest {
    private static final Catalog CATALOG = Catalog.packaged();

    static List<String> sensors() {
        List<String> names = new ArrayList<>(Catalog.packagedNames());
        names.addAll(List.of("north-east-1", "microphone"));
        return names;
    }

    private static SensorSettings<?> sensor(String name) {
        Map<String, SensorSettings<?>> scene =
                new SceneRunner(new MultiSensor()).settings().sensors();
        return scene.containsKey(name)
                ? scene.get(name)
                : CATALOG.settings(name, Map.of("position", new org.dronewatch.geometry.Position(0, 0, 5)));
    }

    @ParameterizedTest
    @MethodSource("sensors")
    void everyShownValueCanBeTypedAsItIsShown(String name) {
        SensorSettings<?> sensor = sensor(name);
        List<SettingRow> rows = SettingRow.of((Record) sensor);

        assertThat(rows).hasSizeGreaterThan(8);
        assertThat(rows.stream().map(SettingRow::path)).doesNotHaveDuplicates();
        assertThat(rows.stream().filter(row -> !row.value().equals(SettingRow.NONE) && !isKind(row)))
                .allSatisfy(row -> assertThat(
                                (Object) new SettingsPath(row.path()).write(sensor, row.withUnit(row.value())))
                        .as("%s of %s as %s", row.path(), name, row.value())
                        .isEqualTo(sensor));
    }

    /** A kind that is typed has the values that it has by default. */
    private static boolean isKind(SettingRow row) {
        return Stream.of(row.allowed().split(", ")).anyMatch(row.value()::equals)
                && row.allowed().contains(", ");
    }

    @Test
    void aSettingHasItsValueItsUnitAndItsLimits() {
        Map<String, SettingRow> rows = SettingRow.of((Record) sensor("north-east-1")).stream()
                .collect(Collectors.toMap(SettingRow::path, Function.identity()));

        assertThat(rows.get("fov").value()).endsWith(" deg");
        assertThat(rows.get("fov").allowed()).isEqualTo("0.01 to 179 deg");
        assertThat(rows.get("fov").withUnit("45")).isEqualTo("45 deg");
        assertThat(rows.get("fov").withUnit("0.5 rad")).isEqualTo("0.5 rad");
        assertThat(rows.get("width").allowed()).contains("1 to 16384");
        assertThat(rows.get("fovAxis").allowed()).contains(", ");
        assertThat(rows).containsKeys("position.x", "aim.azimuth", "rate");
    }
}
