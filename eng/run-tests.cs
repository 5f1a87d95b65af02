#:property PublishAot=false
// a program of one file is named after what it does and needs no namespace
#pragma warning disable MA0048, MA0047, CA1050

// Runs xunit's console for .NET in this process, which eng/arm.sh publishes for another processor: test hosts are
// started by programs that there are for the host's processor only. The tests lie beside this program, xunit's files beside its
// console. Usage: run-tests xunit.console.dll TESTS.dll [options of xunit]
using System;
using System.IO;
using System.Linq;
using System.Runtime.Loader;

string console = Path.GetFullPath(args[0]);
string[] folders = [AppContext.BaseDirectory, Path.GetDirectoryName(console)!];
AssemblyLoadContext.Default.Resolving += (context, name) =>
    folders.Select(folder => Path.Combine(folder, name.Name + ".dll")).FirstOrDefault(File.Exists) is { } path
        ? context.LoadFromAssemblyPath(path)
        : null;
return (int)AssemblyLoadContext.Default.LoadFromAssemblyPath(console).EntryPoint!.Invoke(null, [args[1..]])!;
