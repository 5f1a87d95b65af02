using System;
using System.IO;
using System.Linq;
using Xunit;

namespace Rabit.Diagnostics.Tests;

/// <summary>A test that needs a process of another user, which only root can start.</summary>
[AttributeUsage(AttributeTargets.Method)]
internal sealed class OtherUserFactAttribute : FactAttribute
{
    public OtherUserFactAttribute()
    {
        string[] folders = (Environment.GetEnvironmentVariable("PATH") ?? string.Empty).Split(Path.PathSeparator);
        if (Environment.UserName != "root" || !IsThere("setpriv") || !IsThere("socat"))
            Skip = "it needs root, setpriv and socat";

        bool IsThere(string program) => folders.Any(f => File.Exists(Path.Combine(f, program)));
    }
}
