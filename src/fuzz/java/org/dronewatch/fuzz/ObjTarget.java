package org.dronewatch.fuzz;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.dronewatch.geometry.AABB;
import org.dronewatch.geometry.TriangleMesh;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.setting.InputException;

/** Model files and their materials: what is read is what was written, and time and memory are in proportion. */
final class ObjTarget implements FuzzTarget {
    private static final String MODEL = "model.obj";
    private static final String SCENE = "scene.yaml";
    private static final List<String> PACKAGED = List.of("house.obj", "quadrotor.obj", "hill.obj");
    private static final double SAME = 1e-5;

    /** Mistakes of a file as a whole have no line. */
    private static final Pattern PLACED =
            Pattern.compile("(?s).*model\\.obj(:\\d+)?: .*|.*model\\.obj .*cannot be read.*|.*out of memory.*");

    private static final Pattern WHOLE_FILE = Pattern.compile("(?s).*(has no faces|has an area|not a mesh|empty).*");

    /** Large files of one kind each; one of every so many cases is large. */
    private static final List<String> LARGE =
            List.of("polygon", "face-line", "materials", "libraries", "continued", "long-line");

    private static final int LARGE_EVERY = 30;

    @Override
    public String name() {
        return "obj";
    }

    @Override
    public Duration longest() {
        return Duration.ofSeconds(6);
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        if (number % LARGE_EVERY == 7) {
            return large(dice, LARGE.get((int) (number / LARGE_EVERY % LARGE.size())));
        }
        return switch (dice.below(3)) {
            case 0 -> scene("damaged", mutated(dice), dice);
            case 1 -> scene("written and damaged", ByteMutation.of(written(dice), dice), dice);
            default -> scene("written", written(dice), dice);
        };
    }

    private static FuzzCase scene(String what, byte[] model, Dice dice) {
        return FuzzCase.of(
                        what + " model", SCENE, "world: {models: [" + MODEL + ", site.obj]}\n", "check", "{}/" + SCENE)
                .with(MODEL, model)
                .with("site.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
                .with("model.mtl", MtlWriting.file(dice));
    }

    private static byte[] written(Dice dice) {
        return ((dice.oneIn(3) ? "mtllib model.mtl\n" : "") + ObjWriting.file(dice)).getBytes(StandardCharsets.UTF_8);
    }

    private static byte[] mutated(Dice dice) {
        try {
            String whole = Files.readString(Path.of("models", dice.pick(PACKAGED)));
            String text = dice.oneIn(20) && whole.length() < 400_000 ? whole : cut(whole, dice);
            return ByteMutation.of(text.getBytes(StandardCharsets.UTF_8), dice);
        } catch (IOException e) {
            throw new IllegalStateException("a packaged model cannot be read", e);
        }
    }

    /** Some vertices and some faces between them. */
    private static String cut(String whole, Dice dice) {
        StringBuilder text = new StringBuilder();
        int[] vertices = new int[1];
        whole.lines()
                .filter(line -> line.startsWith("v "))
                .limit(dice.between(3, 200))
                .forEach(line -> {
                    text.append(line).append('\n');
                    vertices[0]++;
                });
        for (int i = dice.between(1, 100); i > 0; i--) {
            text.append('f');
            for (int corner = 0; corner < 3; corner++) {
                text.append(' ').append(1 + dice.below(vertices[0]));
            }
            text.append('\n');
        }
        return text.toString();
    }

    private static FuzzCase large(Dice dice, String kind) {
        int size =
                switch (kind) {
                    case "polygon" -> dice.between(3_000, 12_000);
                    case "materials" -> dice.between(45_000, 60_000);
                    case "face-line" -> dice.between(80_000, 160_000);
                    case "long-line" -> dice.between(100_000, 3_000_000);
                    default -> dice.between(20_000, 60_000);
                };
        FuzzCase input = scene(
                "large model of kind " + kind,
                SpecialFile.largeFile(kind, size).getBytes(StandardCharsets.UTF_8),
                dice);
        return kind.equals("materials") ? input.with("model.mtl", MtlWriting.many(size)) : input;
    }

    @Override
    public void judge(FuzzCase input, Path directory) throws IOException {
        PlainObj expected = PlainObj.read(new String(input.files().get(MODEL), StandardCharsets.UTF_8));
        LoadedModel[] loaded = new LoadedModel[1];
        String[] message = new String[1];
        Judge.inProportion(input.bytes(), () -> {
            try {
                loaded[0] = new ModelLoader(directory).loadAsWritten(MODEL);
            } catch (InputException e) {
                message[0] = e.getMessage();
            }
        });
        if (loaded[0] == null) {
            refused(expected, message[0], directory);
        } else {
            compare(expected, loaded[0].mesh());
            if (expected.verdict() == PlainObj.Verdict.ODD
                    && expected.hasNonsense()
                    && loaded[0].warnings().isEmpty()) {
                throw new Failure("a word that is no statement is refused or warned of", "the file was read");
            }
        }
        CommandRun[] run = new CommandRun[1];
        Judge.inProportion(2 * input.bytes(), () -> run[0] = Judge.run(directory, input.argumentsIn(directory)));
        if ((run[0].code() == 0) != (loaded[0] != null)) {
            throw new Failure(
                    "check and the loader agree",
                    "exit code " + run[0].code() + ": " + Messages.firstLine(run[0].err()));
        }
    }

    private static void refused(PlainObj expected, String message, Path directory) {
        if (expected.verdict() == PlainObj.Verdict.VALID) {
            throw new Failure("a file that is right is read", message);
        }
        Optional<String> fault = Messages.fault(message, directory);
        if (fault.isPresent() || message.contains("\n")) {
            throw new Failure("one short plain line", fault.orElse(message));
        }
        boolean hasLine = message.matches("(?s).*model\\.obj:\\d+: .*");
        if (!PLACED.matcher(message).matches()
                || !hasLine && !WHOLE_FILE.matcher(message).matches()) {
            throw new Failure("a message with file and line", message);
        }
    }

    private static void compare(PlainObj expected, TriangleMesh mesh) {
        if (expected.verdict() == PlainObj.Verdict.UNSURE) {
            return;
        }
        double area = 0;
        for (int i = 0; i < mesh.triangleCount(); i++) {
            area += mesh.triangle(i).area();
        }
        if (expected.areaIsKnown() && !(Math.abs(area - expected.area()) <= SAME * expected.area())) {
            throw new Failure("the area of its faces" + with(expected), "area " + area + ", not " + expected.area());
        }
        double[] extent = extent(mesh);
        double size = Math.max(extent[0], Math.max(extent[1], extent[2]));
        for (int axis = 0; axis < 3 && expected.extentIsKnown(); axis++) {
            if (!(Math.abs(extent[axis] - expected.extent(axis)) <= SAME * size)) {
                throw new Failure(
                        "the extent of its faces" + with(expected),
                        "extent " + extent[axis] + " along axis " + "xyz".charAt(axis) + ", not "
                                + expected.extent(axis));
            }
        }
    }

    private static String with(PlainObj file) {
        return file.traits().isEmpty() ? "" : ", with " + String.join(", ", file.traits());
    }

    private static double[] extent(TriangleMesh mesh) {
        AABB box = mesh.bounds();
        return new double[] {box.maxX() - box.minX(), box.maxY() - box.minY(), box.maxZ() - box.minZ()};
    }
}
