package org.dronewatch.scenario;

import java.io.IOException;
import java.io.InputStream;
import org.dronewatch.setting.Kind;
import org.dronewatch.setting.KindRegistry;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/**
 * Descriptions of the library's own settings, collected from the sources at build time; for a third-party kind, only
 * the {@link Kind#summary()}. Immutable.
 */
public final class PackagedTexts implements SettingTexts {
    /**
     * Resource file next to this class; maps class name, then component name, to text (the empty name represents the
     * record).
     */
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
