package org.dronewatch.placement.solver;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.dronewatch.placement.Candidate;
import org.dronewatch.placement.CandidateColumn;
import org.dronewatch.placement.CandidateTable;

/** Instances with known optima; their sources are in the README beside them. */
final class KnownInstances {
    private static final Path DIRECTORY = Path.of("src/test/resources/org/dronewatch/placement");

    private KnownInstances() {}

    private static List<String> lines(String name) {
        try {
            return Files.readAllLines(DIRECTORY.resolve(name), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** A network of the OR-Library: the impacts are the lengths of the shortest paths. */
    static CandidateTable network(String name) {
        List<String> lines = lines(name);
        int size = Integer.parseInt(lines.get(0).strip().split("\\s+")[0]);
        double[][] length = new double[size][size];
        for (double[] row : length) {
            Arrays.fill(row, Double.POSITIVE_INFINITY);
        }
        for (String line : lines.subList(1, lines.size())) {
            if (!line.isBlank()) {
                String[] edge = line.strip().split("\\s+");
                int from = Integer.parseInt(edge[0]) - 1;
                int to = Integer.parseInt(edge[1]) - 1;
                length[from][to] = Double.parseDouble(edge[2]);
                length[to][from] = length[from][to];
            }
        }
        for (int through = 0; through < size; through++) {
            length[through][through] = 0.0;
        }
        shorten(length);
        return dense(length);
    }

    /** How many vertices of a network are to be chosen. */
    static int chosen(String name) {
        return Integer.parseInt(lines(name).get(0).strip().split("\\s+")[2]);
    }

    private static void shorten(double[][] length) {
        for (int through = 0; through < length.length; through++) {
            for (double[] row : length) {
                for (int to = 0; to < length.length; to++) {
                    row[to] = Math.min(row[to], row[through] + length[through][to]);
                }
            }
        }
    }

    private static CandidateTable dense(double[][] length) {
        List<Candidate> candidates = new ArrayList<>();
        List<CandidateColumn> columns = new ArrayList<>();
        int[] rows = new int[length.length];
        Arrays.setAll(rows, row -> row);
        for (int candidate = 0; candidate < length.length; candidate++) {
            candidates.add(new Candidate(String.valueOf(candidate + 1), 1.0));
            columns.add(new CandidateColumn(rows, length[candidate]));
        }
        double[] weights = new double[length.length];
        Arrays.fill(weights, 1.0);
        return new CandidateTable(candidates, columns, weights);
    }

    /** The water network Net3: scenarios with equal probabilities, and the impact where a sensor detects them. */
    static CandidateTable waterNetwork() {
        Map<Integer, Map<Integer, Double>> bySensor = new TreeMap<>();
        Map<Integer, Double> undetected = new TreeMap<>();
        List<String> lines = lines("net3.impact");
        for (String line : lines.subList(2, lines.size())) {
            String[] field = line.strip().split("\\s+");
            int scenario = Integer.parseInt(field[0]);
            int sensor = Integer.parseInt(field[1]);
            double impact = Double.parseDouble(field[3]);
            if (sensor < 0) {
                undetected.put(scenario, impact);
            } else {
                bySensor.computeIfAbsent(sensor, key -> new TreeMap<>()).put(scenario, impact);
            }
        }
        List<Integer> scenarios = new ArrayList<>(undetected.keySet());
        double[] weights = new double[scenarios.size()];
        Arrays.fill(weights, 1.0 / scenarios.size());
        List<Candidate> candidates = new ArrayList<>();
        List<CandidateColumn> columns = new ArrayList<>();
        bySensor.forEach((sensor, impacts) -> {
            candidates.add(new Candidate(String.valueOf(sensor), 1.0));
            columns.add(new CandidateColumn(
                    impacts.keySet().stream().mapToInt(scenarios::indexOf).toArray(),
                    impacts.values().stream().mapToDouble(Double::doubleValue).toArray()));
        });
        return new CandidateTable(
                candidates,
                columns,
                weights,
                undetected.values().stream().mapToDouble(Double::doubleValue).toArray());
    }

    /** Stores of San Francisco, and the census tracts within 5000 m of each, by their demand or each as one. */
    static CandidateTable stores(boolean byDemand) {
        Map<String, Integer> tracts = new LinkedHashMap<>();
        Map<String, List<Integer>> covered = new TreeMap<>();
        List<Double> demands = new ArrayList<>();
        List<String> lines = lines("sf_distance.csv");
        for (String line : lines.subList(1, lines.size())) {
            String[] field = line.split(",");
            int tract = tracts.computeIfAbsent(field[2], name -> tracts.size());
            if (tract == demands.size()) {
                demands.add(byDemand ? Double.parseDouble(field[3]) : 1.0);
            }
            List<Integer> ofStore = covered.computeIfAbsent(field[1], name -> new ArrayList<>());
            if (Double.parseDouble(field[0]) <= 5000.0) {
                ofStore.add(tract);
            }
        }
        List<Candidate> candidates = new ArrayList<>();
        List<CandidateColumn> columns = new ArrayList<>();
        covered.forEach((store, ofStore) -> {
            candidates.add(new Candidate(store, 1.0));
            int[] rows = ofStore.stream().mapToInt(Integer::intValue).sorted().toArray();
            double[] ones = new double[rows.length];
            Arrays.fill(ones, 1.0);
            columns.add(new CandidateColumn(rows, ones));
        });
        return new CandidateTable(
                candidates,
                columns,
                demands.stream().mapToDouble(Double::doubleValue).toArray());
    }
}
