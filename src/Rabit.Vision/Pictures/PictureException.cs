using System;

namespace Rabit.Vision;

/// <summary>
/// A picture, or the folder of a camera, could not be read or written. The message is one line that names it and the
/// reason, fit for a user.
/// </summary>
/// <example>
/// <code>
/// try
/// {
///     picture = PictureFile.Load(path);
/// }
/// catch (PictureException e)
/// {
///     Console.Error.WriteLine(e.Message);   // names the file and what is wrong with it
/// }
/// </code>
/// </example>
public sealed class PictureException : Exception
{
    /// <summary>Makes the error.</summary>
    /// <param name="name">The file or folder, or what else the data are called.</param>
    /// <param name="reason">What is wrong, one line.</param>
    /// <param name="innerException">What the operating system or the runtime said, if anything.</param>
    public PictureException(string name, string reason, Exception? innerException = null)
        : base($"{name}: {reason}", innerException)
    {
        Name = name;
        Reason = reason;
    }

    /// <summary>The file or folder, or what else the data are called.</summary>
    public string Name { get; }

    /// <summary>What is wrong, one line.</summary>
    public string Reason { get; }
}
