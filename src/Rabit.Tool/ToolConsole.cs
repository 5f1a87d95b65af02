using System;
using System.CommandLine;
using System.IO;

namespace Rabit.Tool;

/// <summary>Where a command reads and writes. The base class has its output and its error output.</summary>
internal sealed class ToolConsole : InvocationConfiguration
{
    public ToolConsole() => EnableDefaultExceptionHandler = false;

    /// <summary>Standard input, or what stands for it.</summary>
    public TextReader Input { get; set; } = Console.In;
}
