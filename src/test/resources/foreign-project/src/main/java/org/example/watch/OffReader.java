package org.example.watch;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.Scanner;
import java.util.Set;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.MeshReader;
import org.dronewatch.mesh.io.ModelCollector;
import org.dronewatch.mesh.io.ModelFile;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.InputException;

/** Reads OFF files: counts, then vertices, then faces. */
public final class OffReader implements MeshReader {
    @Override
    public Set<String> extensions() {
        return Set.of("off");
    }

    @Override
    public String summary() {
        return "Object File Format";
    }

    @Override
    public LoadedModel read(ModelFile file, ModelSettings settings) {
        ModelCollector collector = new ModelCollector(file, settings);
        try (Scanner words = new Scanner(new BufferedReader(file.text()))) {
            if (!words.next().equals("OFF")) {
                throw new InputException(file.name() + ": must begin with OFF");
            }
            int vertices = Integer.parseInt(words.next());
            int faces = Integer.parseInt(words.next());
            words.next();
            for (int i = 0; i < vertices; i++) {
                collector.addVertex(number(words), number(words), number(words));
            }
            for (int i = 0; i < faces; i++) {
                int[] corners = new int[Integer.parseInt(words.next())];
                for (int k = 0; k < corners.length; k++) {
                    corners[k] = Integer.parseInt(words.next());
                }
                collector.addFace("stone", corners);
            }
        } catch (IOException | RuntimeException e) {
            throw new InputException(file.name() + ": " + e.getMessage(), e);
        }
        return collector.toModel();
    }

    private static double number(Scanner words) {
        return Double.parseDouble(words.next());
    }
}
