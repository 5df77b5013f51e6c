package org.example.watch;

import java.io.BufferedReader;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.dronewatch.mesh.io.LoadedModel;
import org.dronewatch.mesh.io.MeshReader;
import org.dronewatch.mesh.io.ModelCollector;
import org.dronewatch.mesh.io.ModelFile;
import org.dronewatch.mesh.io.ModelSettings;
import org.dronewatch.setting.InputException;

/** Reads STL files of the kind that is text. */
public final class StlReader implements MeshReader {
    @Override
    public Set<String> extensions() {
        return Set.of("stl");
    }

    @Override
    public String summary() {
        return "STL as text";
    }

    @Override
    public LoadedModel read(ModelFile file, ModelSettings settings) {
        ModelCollector collector = new ModelCollector(file, settings);
        List<Integer> corners = new ArrayList<>();
        try (BufferedReader text = new BufferedReader(file.text())) {
            for (String line = text.readLine(); line != null; line = text.readLine()) {
                String[] words = line.strip().split("\\s+");
                if (words.length == 4 && words[0].equals("vertex")) {
                    corners.add(collector.addVertex(
                            Float.parseFloat(words[1]), Float.parseFloat(words[2]), Float.parseFloat(words[3])));
                } else if (words[0].equals("endloop")) {
                    collector.addFace("stone", corners.stream().mapToInt(i -> i).toArray());
                    corners.clear();
                }
            }
        } catch (IOException | NumberFormatException e) {
            throw new InputException(file.name() + ": " + e.getMessage(), e);
        }
        return collector.toModel();
    }
}
