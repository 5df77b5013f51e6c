package org.dronewatch.run.store;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import java.util.Map;
import java.util.Optional;
import java.util.Properties;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Where prepared sites are kept. */
class StorePlaceTest {
    @TempDir
    private Path home;

    private final Properties properties = new Properties();

    @BeforeEach
    void findHome() {
        properties.setProperty("user.home", home.toString());
        properties.setProperty("os.name", "Linux");
    }

    private Optional<Path> place(Map<String, String> environment) {
        return StorePlace.directory(properties, environment);
    }

    @Test
    void eachPlatformHasItsPlace() {
        Path other = home.resolve("other");

        assertThat(place(Map.of())).contains(home.resolve(".cache/dronewatch"));
        assertThat(place(Map.of("XDG_CACHE_HOME", other.toString()))).contains(other.resolve("dronewatch"));
        assertThat(place(Map.of("XDG_CACHE_HOME", "relative"))).contains(home.resolve(".cache/dronewatch"));
        properties.setProperty("os.name", "Mac OS X");
        assertThat(place(Map.of("XDG_CACHE_HOME", other.toString())))
                .contains(home.resolve("Library/Caches/dronewatch"));
        properties.setProperty("os.name", "Windows 11");
        assertThat(place(Map.of("LOCALAPPDATA", other.toString()))).contains(other.resolve("dronewatch/cache"));
        assertThat(place(Map.of())).isEmpty();
    }

    @Test
    void thePropertyCountsBeforeTheVariable() {
        Path one = home.resolve("one");
        Path two = home.resolve("two");

        assertThat(place(Map.of("DRONEWATCH_CACHE", one.toString()))).contains(one);
        assertThat(place(Map.of("DRONEWATCH_CACHE", "OFF"))).isEmpty();
        properties.setProperty("dronewatch.cache", two.toString());
        assertThat(place(Map.of("DRONEWATCH_CACHE", "off"))).contains(two);
        properties.setProperty("dronewatch.cache", "off");
        assertThat(place(Map.of("DRONEWATCH_CACHE", one.toString()))).isEmpty();
    }

    @Test
    void withoutAHomeNothingIsKept() {
        for (String none :
                new String[] {"?", "", "relative", home.resolve("missing").toString()}) {
            properties.setProperty("user.home", none);
            assertThat(place(Map.of())).as(none).isEmpty();
        }
        properties.remove("user.home");
        assertThat(place(Map.of())).isEmpty();
        assertThat(place(Map.of("DRONEWATCH_CACHE", "\0"))).isEmpty();
    }
}
