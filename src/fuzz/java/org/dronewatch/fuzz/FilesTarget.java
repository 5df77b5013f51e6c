package org.dronewatch.fuzz;

import java.nio.file.Path;
import java.util.List;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.ModelLoader;
import org.dronewatch.setting.InputException;

/** Names that lead to no plain file, or out of the directory of the scene. */
final class FilesTarget implements FuzzTarget {
    /** The content of files outside the directory of the scene; it must never be shown. */
    private static final String SECRET = "canary-6f1d";

    private static final List<String> SPECIALS = List.of(
            "fifo",
            "link:/dev/zero",
            "directory",
            "unreadable",
            "link:/dev/full",
            "link:{}/outside/secret.mtl",
            "link:nothing",
            "link:/dev/tty",
            "letters:40000000",
            "link:{}/site/scene.yaml");

    /** The places in a site where such a name is used. */
    private static final List<String> ROLES =
            List.of("scene", "model", "use", "neighbour", "materials", "drone", "rays", "out", "hits");

    private static final List<String> WAYS_OUT = List.of(
            "../outside/secret.mtl",
            "link/secret.mtl",
            "linked.mtl",
            "{}/outside/secret.mtl",
            "./../outside/secret.mtl",
            "link/../../outside/secret.mtl",
            "..\\outside\\secret.mtl",
            "sub/../../outside/secret.mtl",
            "chain/secret.mtl",
            "file:{}/outside/secret.mtl",
            "~/secret.mtl",
            "LINK/secret.mtl");

    @Override
    public String name() {
        return "files";
    }

    @Override
    public FuzzCase generate(Dice dice, long number) {
        long round = number / 2;
        if (number % 2 == 0) {
            String role = ROLES.get((int) (round % ROLES.size()));
            return special(role, SPECIALS.get((int) (round / ROLES.size() % SPECIALS.size())));
        }
        return wayOut(dice, WAYS_OUT.get((int) (round % WAYS_OUT.size())));
    }

    private static FuzzCase site(String what, String scene, String... arguments) {
        return FuzzCase.of(what, "site/scene.yaml", scene, arguments)
                .with("site/site.obj", SampleSite.SITE)
                .with("site/drone.obj", SampleSite.DRONE)
                .with(
                        "outside/secret.mtl",
                        "# " + SECRET + "\nnewmtl grass\nKd 0.2 0.4 0.6\nnewmtl " + SECRET + "\nKd 0.2 0.4 0.6\n"
                                + SECRET + "\n")
                .with("outside/secret.yaml", SECRET + ": 1\ntitle: " + SECRET + "\n")
                .with("outside/secret.obj", "v 0 0 0\nv 1 0 0\nv 0 1 " + SECRET + "\nf 1 2 3\n");
    }

    private static FuzzCase special(String role, String kind) {
        String plain = "world: {models: [site.obj]}\n";
        String what = kind + " as " + role;
        return switch (role) {
            case "scene" -> site(what, plain, "check", "{}/site/special.yaml").withSpecial("site/special.yaml", kind);
            case "model" ->
                site(what, "world: {models: [special.obj]}\n", "check", "{}/site/scene.yaml")
                        .withSpecial("site/special.obj", kind);
            case "use" ->
                site(
                                what,
                                plain + "sensors: {s: {use: special, position: [0, 0, 12]}}\n",
                                "check",
                                "{}/site/scene.yaml")
                        .withSpecial("site/special.yaml", kind);
            case "neighbour" ->
                site(what, plain + "sensors: {s: {use: nosuch, position: [0, 0, 12]}}\n", "check", "{}/site/scene.yaml")
                        .withSpecial("site/special.yaml", kind);
            case "materials" -> site(what, plain, "check", "{}/site/scene.yaml").withSpecial("site/site.mtl", kind);
            case "drone" ->
                site(
                                what,
                                plain
                                        + "drones: {d: {model: special.obj, flight: {kind: hover, position: [0, 0, 12]}}}\n",
                                "check",
                                "{}/site/scene.yaml")
                        .withSpecial("site/special.obj", kind);
            case "rays" ->
                site(what, plain, "bench", "{}/site/site.obj", "--rays", "{}/site/special", "--passes", "1")
                        .withSpecial("site/special", kind);
            case "out" ->
                site(
                                what,
                                plain + "run: {duration: 0.1}\n",
                                "run",
                                "{}/site/scene.yaml",
                                "--out",
                                "{}/site/special/out")
                        .withSpecial("site/special", kind);
            default ->
                site(what, plain, "render", "{}/site/scene.yaml", "--out", "{}/site/special/x.png")
                        .withSpecial("site/special", kind);
        };
    }

    private static FuzzCase wayOut(Dice dice, String library) {
        String model = "mtllib " + library + "\n" + SampleSite.SITE.replace("mtllib site.mtl\n", "");
        String scene = dice.pick(
                "world: {models: [site.obj]}\n",
                "world: {models: [site.obj]}\nsensors: {s: {use: ../outside/secret, position: [0, 0, 12]}}\n",
                "world: {models: [site.obj]}\nsensors: {s: {use: link/secret, position: [0, 0, 12]}}\n",
                "world: {models: [site.obj, link/secret.obj]}\n",
                "world: {models: [../outside/secret.obj]}\n",
                "world: {models: ['{}/outside/secret.yaml']}\n");
        return site("materials by " + library, scene, "check", "{}/site/scene.yaml")
                .with("site/site.obj", model)
                .with("site/sub/x.mtl", "newmtl x\n")
                .withSpecial("site/link", "link:{}/outside")
                .withSpecial("site/linked.mtl", "link:../outside/secret.mtl")
                .withSpecial("site/chain", "link:link");
    }

    @Override
    public void judge(FuzzCase input, Path directory) {
        CommandRun[] run = new CommandRun[1];
        Judge.inProportion(20L << 20, () -> run[0] = CommandRun.of(input.argumentsIn(directory)));
        if (run[0].out().contains(SECRET) || run[0].err().contains(SECRET)) {
            throw new Failure("nothing of a file elsewhere is shown", Messages.firstLine(run[0].err()));
        }
        Judge.check(run[0], directory);
        if (input.what().startsWith("materials by") || input.what().endsWith("materials")) {
            checkColours(directory.resolve("site"));
        }
    }

    /** Materials come from the directory of the model only; colours would reveal that another file was read. */
    private static void checkColours(Path site) {
        LoadedModel model;
        try {
            model = new ModelLoader(site).loadAsWritten("site.obj");
        } catch (InputException e) {
            return;
        }
        if (!model.colours().isEmpty()) {
            throw new Failure("no file outside the model's directory is read", "colours " + model.colours());
        }
    }
}
