package org.dronewatch.app;

import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;

/** Files that are not the document that a scene should be. The same seed gives the same files. */
final class BrokenDocuments {
    private static final String GOOD = BrokenSceneFiles.GOOD;
    private static final long SEED = 20_261_121;

    private final NamedFiles files = new NamedFiles();
    private final SplittableRandom random = new SplittableRandom(SEED);

    private BrokenDocuments() {}

    /** All files by a name that says what is wrong. */
    static Map<String, byte[]> all() {
        BrokenDocuments corpus = new BrokenDocuments();
        corpus.aliases();
        corpus.structure();
        corpus.encodings();
        corpus.rubbish();
        return corpus.files.all();
    }

    private void aliases() {
        files.add("cycle", "world: &a\n  models: *a\n");
        files.add("cycle of lists", "world: {models: &a [*a]}\n");
        files.add("alias of nothing", GOOD.replace("seed: 7", "seed: *seven"));
        for (int width : new int[] {2, 10, 50}) {
            StringBuilder laughs = new StringBuilder("a0: &a0 [x]\n");
            for (int level = 1; level < 40; level++) {
                laughs.append("a")
                        .append(level)
                        .append(": &a")
                        .append(level)
                        .append(" [")
                        .append(("*a" + (level - 1) + ", ").repeat(width))
                        .append("]\n");
            }
            files.add("laughs " + width, laughs.toString());
        }
        files.add("tag of a class", GOOD.replace("seed: 7", "seed: !!java.lang.Runtime 7"));
        files.add("tag of a user", GOOD.replace("seed: 7", "seed: !mine 7"));
        files.add("tag of a script", "!!javax.script.ScriptEngineManager [!!java.net.URLClassLoader [[]]]\n");
        files.add("merge key", GOOD.replace("    kind: camera", "    <<: {kind: camera}"));
    }

    private void structure() {
        files.add("nothing", "");
        files.add("a comment", "# nothing here\n");
        files.add("a word", "world\n");
        files.add("a number", "42\n");
        files.add("a list", "- world\n- drones\n");
        files.add("two documents", GOOD + "---\n" + GOOD);
        files.add("open bracket", GOOD.replace("position: [0, 0, 12]", "position: [0, 0, 12"));
        files.add("open brace", GOOD.replace("detection: {pixels: 20}", "detection: {pixels: 20"));
        files.add("open quote", GOOD.replace("seed: 7", "seed: \"7"));
        files.add("tab", GOOD.replace("  duration", "\tduration"));
        files.add("crooked", GOOD.replace("    width: 1280", "   width: 1280"));
        files.add("deep list", "world: " + "[".repeat(5000) + "]".repeat(5000) + "\n");
        files.add("deep mapping", "{a: ".repeat(3000) + "1" + "}".repeat(3000) + "\n");
        files.add("key that is a list", "? [a, b]\n: c\n");
        files.add("world is text", GOOD.replaceFirst("(?s)world:.*drones:", "world: nice\ndrones:"));
        files.add("models are text", "world: {models: hill.obj}\n");
        files.add("drones are a list", "world: {models: [site.obj]}\ndrones: [a, b]\n");
        files.add("sensors are text", "world: {models: [site.obj]}\nsensors: many\n");
        files.add("sensor is text", "world: {models: [site.obj]}\nsensors: {a: blighter-a400}\n");
        files.add("many names", "world: {models: [site.obj]}\nsensors:\n" + "  s: {}\n".repeat(5000));
        files.add("many lists", "world: {models: [" + "[], ".repeat(60_000) + "]}\n");
        files.add("long line", "world: {models: [\"" + "x".repeat(500_000) + "\"]}\n");
        files.add("too large", "# " + "x".repeat(1 << 20) + "\n" + GOOD);
    }

    private void encodings() {
        for (String name : List.of("UTF-16LE", "UTF-16BE", "UTF-16", "UTF-32", "IBM500")) {
            files.add("encoded in " + name, GOOD.getBytes(Charset.forName(name)));
        }
        files.add("Latin 1", GOOD.replace("seed: 7", "seed: 7 # g\u00fcltig").getBytes(StandardCharsets.ISO_8859_1));
        files.add(
                "a byte that is none of UTF-8",
                concat(GOOD.getBytes(StandardCharsets.UTF_8), new byte[] {(byte) 0xC0, 0x20}));
        files.add("a zero byte", GOOD.replace("seed: 7", "seed: \0"));
        files.add("an escape", GOOD.replace("seed: 7", "seed: \u001b[31m7"));
    }

    private static byte[] concat(byte[] a, byte[] b) {
        byte[] both = new byte[a.length + b.length];
        System.arraycopy(a, 0, both, 0, a.length);
        System.arraycopy(b, 0, both, a.length, b.length);
        return both;
    }

    private void rubbish() {
        for (int i = 0; i < 12; i++) {
            byte[] bytes = new byte[1 + random.nextInt(5000)];
            random.nextBytes(bytes);
            files.add("rubbish " + i, bytes);
        }
        List<Character> signs = new ArrayList<>();
        for (char sign : "{}[]:,-?&*!|>'\"%@` \n#ab1".toCharArray()) {
            signs.add(sign);
        }
        for (int i = 0; i < 12; i++) {
            StringBuilder text = new StringBuilder();
            for (int k = 0; k < 300; k++) {
                text.append(signs.get(random.nextInt(signs.size())).charValue());
            }
            files.add("signs " + i, text.toString());
        }
        files.add("a picture", new byte[] {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 0x0D});
        files.add("an archive", new byte[] {'P', 'K', 3, 4, 0x14, 0, 0, 0, 8, 0});
        files.add("a class", new byte[] {(byte) 0xCA, (byte) 0xFE, (byte) 0xBA, (byte) 0xBE, 0, 0, 0, 61});
    }
}
