package org.dronewatch.docs;

import com.sun.source.doctree.DocCommentTree;
import com.sun.source.doctree.DocTree;
import com.sun.source.doctree.LinkTree;
import com.sun.source.doctree.LiteralTree;
import com.sun.source.doctree.ParamTree;
import com.sun.source.tree.ClassTree;
import com.sun.source.tree.CompilationUnitTree;
import com.sun.source.tree.Tree;
import com.sun.source.util.DocTrees;
import com.sun.source.util.JavacTask;
import com.sun.source.util.TreePathScanner;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import javax.tools.JavaCompiler;
import javax.tools.JavaFileObject;
import javax.tools.StandardJavaFileManager;
import javax.tools.ToolProvider;
import org.dronewatch.scenario.SettingTexts;

/** What the Javadoc of the sources says of records and their components: text for people, kept in one place. */
final class RecordTexts implements SettingTexts {
    private final Map<String, String> summaries = new HashMap<>();
    private final Map<String, String> parts = new HashMap<>();

    /** Reads all sources below a directory. */
    static RecordTexts of(Path sources) throws IOException {
        RecordTexts texts = new RecordTexts();
        JavaCompiler compiler = ToolProvider.getSystemJavaCompiler();
        try (StandardJavaFileManager files = compiler.getStandardFileManager(null, null, StandardCharsets.UTF_8);
                Stream<Path> found = Files.walk(sources)) {
            List<Path> java =
                    found.filter(file -> file.toString().endsWith(".java")).toList();
            Iterable<? extends JavaFileObject> units = files.getJavaFileObjectsFromPaths(java);
            JavacTask task =
                    (JavacTask) compiler.getTask(null, files, problem -> {}, List.of("-proc:none"), null, units);
            DocTrees trees = DocTrees.instance(task);
            for (CompilationUnitTree unit : task.parse()) {
                texts.new Reader(trees).scan(unit, "");
            }
        }
        return texts;
    }

    @Override
    public String summary(Class<?> record) {
        return summaries.getOrDefault(name(record), "");
    }

    @Override
    public String part(Class<?> record, String component) {
        return parts.getOrDefault(name(record) + "#" + component, "");
    }

    private static String name(Class<?> type) {
        return type.getName().substring(type.getPackageName().length() + 1).replace('$', '.');
    }

    private final class Reader extends TreePathScanner<Void, String> {
        private final DocTrees trees;

        Reader(DocTrees trees) {
            this.trees = trees;
        }

        @Override
        public Void visitClass(ClassTree tree, String outer) {
            String name = outer.isEmpty() ? tree.getSimpleName().toString() : outer + "." + tree.getSimpleName();
            DocCommentTree comment = trees.getDocCommentTree(getCurrentPath());
            if (comment != null && tree.getKind() == Tree.Kind.RECORD) {
                summaries.put(name, text(comment.getFirstSentence()));
                for (DocTree block : comment.getBlockTags()) {
                    if (block instanceof ParamTree part && !part.isTypeParameter()) {
                        parts.put(name + "#" + part.getName(), text(part.getDescription()));
                    }
                }
            }
            return super.visitClass(tree, name);
        }
    }

    /** As plain text in one line: code and links keep their words. */
    private static String text(List<? extends DocTree> trees) {
        return trees.stream()
                .map(RecordTexts::words)
                .collect(Collectors.joining())
                .replaceAll("\\s+", " ")
                .strip();
    }

    private static String words(DocTree tree) {
        if (tree instanceof LiteralTree code) {
            return code.getBody().getBody();
        }
        if (tree instanceof LinkTree link) {
            return link.getLabel().isEmpty()
                    ? link.getReference().getSignature().replaceFirst("^[\\w.]*#", "")
                    : text(link.getLabel());
        }
        return tree.toString();
    }
}
