using System;
using Observer._1;
using Rabit.Core;
using Rabit.Diagnostics;
using Rabit.Links;
using Rabit.Uav;
using Rabit.Uav.ImageProcessing;
using Rabit.Vision;

// Observes a vehicle over a link, and searches the pictures of a folder for rafts, if there is one.
//     Observer.1 udpin:0.0.0.0:14550
//     Observer.1 serial:/dev/ttyAMA0:921600 pictures/
// Nothing is commanded: UavOptions.MayCommand is false.
if (args.Length is 0 or > 2)
{
    Console.Error.WriteLine("Observer.1 LINK [PICTURES], for example udpin:0.0.0.0:14550");
    return 2;
}

if (!LinkUrl.TryParse(args[0], out LinkUrl? link, out string? error))
{
    Console.Error.WriteLine(error);   // what is wrong with it, and what the right form is
    return 2;
}

try
{
    var options = new UavOptions { Links = [link], OtherManagers = [new Watcher(Console.WriteLine)] };
    if (args.Length == 2)
    {
        CameraFolder pictures = CameraFolder.Open(args[1]);   // pictures, and camera.json, which describes the camera
        options.Camera = new FolderCamera(pictures);
        options.Imaging = new ImageProcessingOptions
        {
            Camera = pictures.Camera,
            Mount = pictures.Mount,
            TargetClasses = [RaftDetector.Raft],
            Detector = new RaftDetector(),
        };
    }

    using UavSystem uav = UavSystem.Open(options);
    RabitReactor reactor = uav.CreateReactor(new ReactorOptions());
    using var diagnostics = RabitDiagnostics.Open(reactor);   // "rabit top" shows the managers while they run
    return (await reactor.RunAsync()).ExitCode;   // until Ctrl-C, SIGTERM or the end of a recorded log
}
catch (Exception e) when (e is LinkException or PictureException)
{
    Console.Error.WriteLine(e.Message);   // one line that names the link or the file, and the reason
    return 1;
}
