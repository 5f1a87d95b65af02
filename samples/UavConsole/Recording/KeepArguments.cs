using System.Collections.Generic;
using System.CommandLine;
using System.CommandLine.Parsing;
using System.Linq;
using Rabit.Uav.ImageProcessing;

namespace UavConsole;

/// <summary>The options of the pictures that a flight keeps.</summary>
internal static class KeepArguments
{
    private static readonly Option<string?> Folder = new("--keep-pictures")
    {
        Description = "Keeps the pictures in which something was reported, as PNG that say by EXIF and XMP where they "
            + "were taken and how the camera was turned: rabit geolocate locates their pixels. Without it no picture "
            + "is kept but in the report.",
        HelpName = "DIR",
    };

    private static readonly Option<bool> All = new("--keep-all-pictures")
    {
        Description = "With --keep-pictures: every picture that was searched.",
    };

    /// <summary>Both of them.</summary>
    public static IEnumerable<Option> Options => [Folder, All];

    /// <summary>What the command line asked for; else what the configuration file says.</summary>
    public static KeptPictureOptions? Read(ParseResult result, ConfigFile? config)
        => result.GetValue(Folder) is { } folder
            ? new KeptPictureOptions { Folder = folder, KeepsAll = result.GetValue(All) }
            : config?.Options.Imaging.KeptPictures;

    public static IEnumerable<string> FindFaults(ParseResult result, bool isReplay)
    {
        if (result.GetValue(Folder) is null)
        {
            if (result.GetValue(All))
                yield return $"{All.Name} needs {Folder.Name} DIR.";
            yield break;
        }

        if (isReplay)
            yield return $"{Folder.Name} needs a camera: what is played has no pictures.";
    }
}
