package org.dronewatch.setting;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayInputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Map;
import java.util.Set;
import org.dronewatch.setting.file.Kinds;
import org.dronewatch.setting.file.SettingsFile;
import org.junit.jupiter.api.Test;

/** The word that switches, in files and in overrides. */
class SwitchableTest {
    record Lamp(int power, boolean enabled) {
        @Defaults
        static final Lamp DEFAULT = new Lamp(5, true);
    }

    record Room(@Switchable("off") Map<String, Lamp> lamps, Set<String> off) {
        @Defaults
        static final Room DEFAULT = new Room(Map.of(), Set.of());
    }

    @Test
    void itIsTheSwitchInAFileAndInAnOverrideWhateverTheRecord() throws Exception {
        byte[] text = "lamps: {desk: {power: 7, enabled: false}}\n".getBytes(StandardCharsets.UTF_8);
        Room read = SettingsFile.read(
                SettingsFile.document("room.yaml", new ByteArrayInputStream(text)),
                Room.class,
                Kinds.FOUND,
                Path.of(""),
                new FormerNames());
        Room lit = new Room(Map.of("desk", new Lamp(7, true)), Set.of());
        SettingsPath path = new SettingsPath("lamps.desk.enabled");
        Room written = path.write(lit, "false");

        assertThat(read).isEqualTo(new Room(Map.of("desk", new Lamp(7, true)), Set.of("desk")));
        assertThat(written).isEqualTo(read);
        assertThat(path.read(written)).isEqualTo(false);
        assertThat(path.<Room>write(written, "true")).isEqualTo(lit);
    }
}
