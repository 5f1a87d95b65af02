using System.IO;

namespace Rabit.Uav.ImageProcessing;

/// <summary>
/// A file that is written under another name first, so that who looks into the folder never reads half of it.
/// </summary>
internal static class PartialFile
{
    public const string Ending = ".part";

    /// <summary>Where it is written.</summary>
    /// <param name="path">Where it will be.</param>
    public static string PathOf(string path) => path + Ending;

    /// <summary>Moves it to its place, over what is there.</summary>
    /// <exception cref="IOException">It cannot be moved.</exception>
    /// <exception cref="System.UnauthorizedAccessException">So.</exception>
    public static void Complete(string path)
    {
        File.Delete(path);
        File.Move(PathOf(path), path);
    }
}
