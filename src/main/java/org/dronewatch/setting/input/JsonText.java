package org.dronewatch.setting.input;

import org.dronewatch.setting.InputException;
import org.dronewatch.setting.PlainText;
import tools.jackson.core.JacksonException;
import tools.jackson.core.TokenStreamLocation;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/** Reads JSON files named by the user; the JSON library limits their nesting depth. */
public final class JsonText {
    /** Bytes that the tree takes for each character of its syntax, from the sizes of its objects. */
    private static final int ARRAY = 112;

    private static final int OBJECT = 160;
    private static final int FIELD = 136;
    private static final int ELEMENT = 40;
    private static final int QUOTE = 32;
    private static final int CHARACTER = 3;

    private JsonText() {}

    /**
     * Reads a document that must fit into a budget of memory.
     *
     * @param name name of the document in messages
     * @param budget memory for the document and its tree
     * @throws InputException with a one-line message when it is not JSON, or exceeds the budget
     */
    public static JsonNode read(String name, byte[] bytes, HeapBudget budget) {
        budget.take(memory(bytes));
        return read(name, bytes);
    }

    /** An estimate of the memory that a document and its tree take, bytes; it is more likely too high than too low. */
    public static long memory(byte[] bytes) {
        long memory = (long) CHARACTER * bytes.length;
        boolean isText = false;
        for (int i = 0; i < bytes.length; i++) {
            switch (bytes[i]) {
                case '"' -> {
                    memory += QUOTE;
                    isText = !isText;
                }
                case '\\' -> i += isText ? 1 : 0;
                case '[' -> memory += isText ? 0 : ARRAY;
                case '{' -> memory += isText ? 0 : OBJECT;
                case ':' -> memory += isText ? 0 : FIELD;
                case ',' -> memory += isText ? 0 : ELEMENT;
                default -> {
                    // Part of a text or a number.
                }
            }
        }
        return memory;
    }

    /**
     * Reads a document.
     *
     * @param name name of the document in messages
     * @throws InputException with a one-line message when it is not JSON
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
