package org.dronewatch.scene;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.dronewatch.Thorough;
import org.dronewatch.catalog.Catalog;
import org.dronewatch.catalog.CatalogEntry;
import org.dronewatch.catalog.SensorKinds;
import org.dronewatch.scenario.SceneSettings;
import org.dronewatch.setting.CurrentPath;
import org.dronewatch.setting.FormerNames;
import org.dronewatch.setting.Formerly;
import org.dronewatch.setting.SettingsForm;
import org.dronewatch.setting.SettingsPath;
import org.dronewatch.setting.file.Kinds;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Every former name of a setting means what its current name means. */
class FormerNamesTest {
    private static final long SEED = Long.getLong("dronewatch.seed", 20_261_122L);
    private static final int SCENES = 300;
    private static final Kinds KINDS = SensorKinds.kinds(Catalog.packaged());

    @TempDir
    private Path directory;

    private static Set<Class<?>> records() {
        Set<Type> seen = new LinkedHashSet<>();
        collect(SceneSettings.class, seen);
        collect(CatalogEntry.class, seen);
        Set<Class<?>> records = new LinkedHashSet<>();
        seen.forEach(type -> {
            if (type instanceof Class<?> plain && plain.isRecord()) {
                records.add(plain);
            }
        });
        return records;
    }

    private static void collect(Type type, Set<Type> seen) {
        if (!seen.add(type)) {
            return;
        }
        if (type instanceof ParameterizedType several) {
            collect(several.getRawType(), seen);
            List.of(several.getActualTypeArguments()).forEach(inner -> collect(inner, seen));
        } else if (type instanceof Class<?> plain && KINDS.isChoice(plain)) {
            KINDS.of(plain).values().forEach(kind -> collect(kind, seen));
        } else if (type instanceof Class<?> plain && plain.isRecord()) {
            SettingsForm.of(plain).parts().forEach(part -> collect(part.getGenericType(), seen));
        }
    }

    private static List<String> formerNames(RecordComponent part) {
        Formerly names = part.getAnnotation(Formerly.class);
        return names == null ? List.of() : List.of(names.value());
    }

    /**
     * The words that files use beside the names of settings cannot be former names; those of other settings cannot
     * either.
     */
    @Test
    void aFormerNameIsNoOtherNameOfTheSameRecord() {
        Set<Class<?>> records = records();
        assertThat(records).hasSizeGreaterThan(40);
        for (Class<?> record : records) {
            List<String> names = new ArrayList<>(List.of("kind", "use", "enabled"));
            for (RecordComponent part : record.getRecordComponents()) {
                names.addAll(formerNames(part));
            }
            for (RecordComponent part : record.getRecordComponents()) {
                assertThat(names).as("former names of %s", record).doesNotContain(part.getName());
            }
            assertThat(names).as("former names of %s", record).doesNotHaveDuplicates();
        }
    }

    @Thorough
    @Test
    void aSceneWrittenByFormerNamesReadsToTheSameSettings() throws IOException {
        System.out.println("scenes by former names from seed " + SEED);
        RandomScenes.writeFiles(directory);
        Set<String> used = new HashSet<>();
        for (long seed = SEED; seed < SEED + SCENES; seed++) {
            SceneSettings settings = RandomScenes.of(seed);
            int turn = (int) (seed - SEED);
            String text = SettingsText.of(settings, KINDS, part -> formerName(part, turn, used));
            Path file = Files.writeString(directory.resolve("scene.yaml"), text);
            assertThat(new SceneRunner(new SceneFile(file)).settings())
                    .as("scene of seed %d", seed)
                    .isEqualTo(settings);
            checkPaths(settings, settings, "", seed);
        }
        Set<String> all = new HashSet<>();
        records().forEach(record -> SettingsForm.of(record)
                .renamed()
                .keySet()
                .forEach(name -> all.add(record.getName() + "." + name)));
        assertThat(used).isEqualTo(all);
    }

    /** One former name after another of a component that has some. */
    private static String formerName(RecordComponent part, int turn, Set<String> used) {
        List<String> names = formerNames(part);
        if (names.isEmpty()) {
            return part.getName();
        }
        String name = names.get(turn % names.size());
        used.add(part.getDeclaringRecord().getName() + "." + name);
        return name;
    }

    /** Reads every renamed setting of a tree by both of its names. */
    private static void checkPaths(SceneSettings tree, Object here, String path, long seed) {
        if (here instanceof Optional<?> optional) {
            optional.ifPresent(inside -> checkPaths(tree, inside, path, seed));
        } else if (here instanceof Map<?, ?> map) {
            map.forEach((id, inside) -> checkPaths(tree, inside, path + id + ".", seed));
        } else if (here instanceof Record settings) {
            for (RecordComponent part : SettingsForm.of(settings.getClass()).parts()) {
                for (String former : formerNames(part)) {
                    String present = path + part.getName();
                    assertThat(new SettingsPath(path + former).read(tree))
                            .as("%s%s, scene of seed %d", path, former, seed)
                            .isEqualTo(new SettingsPath(present).read(tree));
                    assertThat(new CurrentPath(tree, new FormerNames()).of(path + former, ""))
                            .isEqualTo(present);
                }
                checkPaths(tree, SettingsForm.get(settings, part), path + part.getName() + ".", seed);
            }
        }
    }
}
