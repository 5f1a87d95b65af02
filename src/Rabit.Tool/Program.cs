using System;
using System.Text;
using Rabit.Tool;

// Names and units are not ASCII alone, and a pipe has no byte order mark.
Console.OutputEncoding = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false);
Console.SetOut(StandardOutput.CreateWriter());
return CommandLine.Run(args, new ToolConsole());
