package org.dronewatch.setting.file;

import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import tools.jackson.core.JacksonException;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reads JSON files named by the user; the library limits their nesting depth. */
public final class JsonText {
    private JsonText() {}

    /**
     * The document.
     *
     * @param name its name in messages
     * @throws InputException in one line when it is not JSON
     */
    public static JsonNode read(String name, byte[] bytes) {
        try {
            return JsonMapper.shared().readTree(bytes);
        } catch (JacksonException e) {
            TokenStreamLocation at = e.getLocation();
            String line = at == null || at.getLineNr() < 1 ? "" : ":" + at.getLineNr();
            // Without the name of the library's own setting.
            String why = PlainText.line(e.getOriginalMessage()).replaceFirst(", from `.*?`", "");
            throw new InputException(
                    name + line + ": not valid JSON: " + PlainText.beginning(why, PlainText.LONGEST), e);
        }
    }
}
