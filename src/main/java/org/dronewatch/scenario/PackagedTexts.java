package org.dronewatch.scenario;

import java.io.IOException;
import java.io.InputStream;
import org.dronewatch.setting.Kind;
import org.dronewatch.setting.KindRegistry;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * The texts on the library's own settings, which the build collects from the sources; of a kind from elsewhere only what its
 * {@link Kind} says. Immutable.
 */
public final class PackagedTexts implements SettingTexts {
    /** Beside this class: by name of the class, then by component, the empty name for the record itself. */
    private static final String FILE = "texts.json";

    private final JsonNode texts;

    /** Reads the texts. */
    public PackagedTexts() {
        try (InputStream in = PackagedTexts.class.getResourceAsStream(FILE)) {
            if (in == null) {
                throw new IllegalStateException("resource " + FILE + " is missing");
            }
            texts = JsonMapper.builder().build().readTree(in);
        } catch (IOException e) {
            throw new IllegalStateException("resource " + FILE + " cannot be read", e);
        }
    }

    @Override
    public String summary(Class<?> record) {
        String own = part(record, "");
        return own.isEmpty()
                ? KindRegistry.found().kindOf(record).map(Kind::summary).orElse("")
                : own;
    }

    @Override
    public String part(Class<?> record, String component) {
        return texts.path(record.getName()).path(component).asString("");
    }
}
