import java.io.File;
import org.sunflow.SunflowAPI;
import org.sunflow.core.display.FileDisplay;
import org.sunflow.core.parser.SCParser;
import org.sunflow.system.UI;
import org.sunflow.system.ui.SilentInterface;

/**
 * Renders a .sc file with Debian's Sunflow, whose own front end has lost the parser, but whose class SCParser still works.
 *
 * Arguments: scene, picture (.png), the two numbers of `aa`, filter, threads.
 */
public class RenderWithSunflow {
    public static void main(String[] arguments) {
        File scene = new File(arguments[0]).getAbsoluteFile();
        UI.set(new SilentInterface());
        SunflowAPI api = new SunflowAPI();
        api.searchpath("texture", scene.getParent());
        api.searchpath("include", scene.getParent());
        if (!new SCParser().parse(scene.getPath(), api)) {
            System.err.println("Sunflow cannot read " + scene);
            System.exit(1);
        }
        // What is said last counts.
        api.parameter("aa.min", Integer.parseInt(arguments[2]));
        api.parameter("aa.max", Integer.parseInt(arguments[3]));
        api.parameter("filter", arguments[4]);
        api.parameter("threads", Integer.parseInt(arguments[5]));
        api.parameter("threads.lowPriority", false);
        api.options(SunflowAPI.DEFAULT_OPTIONS);
        api.build();
        api.render(SunflowAPI.DEFAULT_OPTIONS, new FileDisplay(arguments[1]));
        // Its threads do not end by themselves.
        System.exit(new File(arguments[1]).length() > 0 ? 0 : 1);
    }
}
